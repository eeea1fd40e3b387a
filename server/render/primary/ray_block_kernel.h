// Traces a block of rays, compiled for one width of lanes.
#pragma once

#include "render/primary/primary_block_kernel.h"
#include "render/primary/ray_block.h"

namespace saccade::detail {

template <int W>
[[gnu::always_inline]] inline void traceRays(const PosedScene& scene, float pixel, int first, int count,
                                             RayBlock& block) {
  const LaneSet lanes = LaneSet::first(count);
  RayPacket<W> packet;
  for (int i = 0; i < W; ++i)
    packet.set(i, block.rays[static_cast<std::size_t>(first + (i < count ? i : count - 1))]);
  scene.geometry().template intersect<W>(packet, lanes, EmbreeTracer::Rays::kCoherent);
  const LaneSet plain = plainHits<W>(scene, packet, lanes), others = lanes - plain;
  forEachLane(others, [&](int i) { block.hits[static_cast<std::size_t>(first + i)] = packet.hit(i); });
  block.plain.bits |= plain.bits << first, block.others.bits |= others.bits << first;
  if (!plain.any()) return;
  const SurfaceLanes<W> s = surfacesAt<W>(scene, packet, plain);
  const Floats<W> width = pixel * load<W>(packet.far);
  const PlainLanes<W> surface = plainLanes<W>(scene, packet, plain, s, width);
  storeLanes<W>(s, surface, luminance<Floats<W>>(surface.reflectance), width, first, block.surfaces);
  forEachLane(plain, [&](int i) { block.on[static_cast<std::size_t>(first + i)] = packet.on(i); });
}

template <int W>
void traceRayBlock(const PosedScene& scene, float pixel, RayBlock& block) {
  block.plain = block.others = {};
  for (int first = 0; first < block.count; first += W)
    traceRays<W>(scene, pixel, first, block.count - first < W ? block.count - first : W, block);
}

}  // namespace saccade::detail
