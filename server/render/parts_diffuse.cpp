#include "render/kernel.h"

namespace saccade {

SACCADE_COMPILE_PARTS(kPlainDiffuse)
SACCADE_COMPILE_PARTS(kTexturedDiffuse)

}  // namespace saccade
