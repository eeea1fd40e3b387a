#include "render/kernel.h"

namespace saccade {

SACCADE_COMPILE_PARTS(kPlastics)

}  // namespace saccade
