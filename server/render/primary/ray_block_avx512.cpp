#include "render/primary/ray_block_kernel.h"

namespace saccade {

void traceRayBlockAvx512(const PosedScene& scene, float pixel, RayBlock& block) {
  detail::traceRayBlock<16>(scene, pixel, block);
}

}  // namespace saccade
