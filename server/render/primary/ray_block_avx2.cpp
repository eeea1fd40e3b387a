#include "render/primary/ray_block_kernel.h"

namespace saccade {

void traceRayBlockAvx2(const PosedScene& scene, float pixel, RayBlock& block) {
  detail::traceRayBlock<8>(scene, pixel, block);
}

}  // namespace saccade
