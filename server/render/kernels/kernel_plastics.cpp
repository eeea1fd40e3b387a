#include "render/kernels/kernel.h"

namespace saccade {

SACCADE_COMPILE_KERNEL(kPlastics)

}  // namespace saccade
