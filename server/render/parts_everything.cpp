#include "render/kernel.h"

namespace saccade {

SACCADE_COMPILE_PARTS(kEverything)

}  // namespace saccade
