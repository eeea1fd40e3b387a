#include "render/kernels/kernel.h"

namespace saccade {

SACCADE_COMPILE_KERNEL(kPlainDiffuse)
SACCADE_COMPILE_KERNEL(kTexturedDiffuse)

}  // namespace saccade
