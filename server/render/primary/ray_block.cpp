#include "render/primary/ray_block.h"

#include "base/instruction_set.h"
#include "render/world/coherent_rays.h"

namespace saccade {

void traceRayBlock(const PosedScene& scene, const Camera& lens, RayBlock& block) {
  if (lens.isPlain()) {
    if (instructionSet() == InstructionSet::kAvx512) return traceRayBlockAvx512(scene, lens.pixel, block);
    return traceRayBlockAvx2(scene, lens.pixel, block);
  }
  block.plain = {}, block.others = LaneSet::first(block.count);
  intersectCoherent(scene.geometry(), block.rays,
                    std::span(block.hits).first(static_cast<std::size_t>(block.count)));
}

}  // namespace saccade
