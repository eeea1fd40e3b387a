#include "render/primary/primary_block.h"

#include <limits>

#include "base/instruction_set.h"
#include "render/world/coherent_rays.h"

namespace saccade {
namespace {

// Of a camera with distortion, whose rays are found one by one.
void traceDistorted(const PixelContext& view, Tile pixels, PrimaryBlock& out) {
  const Ray none{view.now.camera.origin, view.now.camera.forward, -1};  // hits nothing
  out.plain = out.others = {};
  out.rays.fill(none);
  for (int y = pixels.y0; y < pixels.y1; ++y)
    for (int x = pixels.x0; x < pixels.x1; ++x) {
      const int lane = (y - pixels.y0) * kBlockEdge + x - pixels.x0;
      out.others.add(lane);
      out.rays[static_cast<std::size_t>(lane)] = {
          view.now.camera.origin, view.now.camera.direction(static_cast<float>(x), static_cast<float>(y)),
          std::numeric_limits<float>::infinity()};
    }
  intersectCoherent(view.now.scene.geometry(), out.rays, out.hits);
}

}  // namespace

void tracePrimaryBlock(const PixelContext& view, Tile pixels, GBuffer& g, PrimaryBlock& out) {
  out.x0 = pixels.x0, out.y0 = pixels.y0;
  if (!view.now.camera.isPlain()) return traceDistorted(view, pixels, out);
  if (instructionSet() == InstructionSet::kAvx512) return tracePrimaryBlockAvx512(view, pixels, g, out);
  tracePrimaryBlockAvx2(view, pixels, g, out);
}

}  // namespace saccade
