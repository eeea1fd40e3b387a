// Rays that lie close together, of any number, in packets.
#pragma once

#include <algorithm>
#include <span>

#include "base/instruction_set.h"
#include "render/world/embree_tracer.h"

namespace saccade {

template <int W>
void intersectCoherent(const auto& shapes, std::span<const Ray> rays, std::span<Hit> hits) {
  RayPacket<W> packet;
  for (std::size_t first = 0; first < hits.size(); first += W) {
    const int count = static_cast<int>(std::min<std::size_t>(W, hits.size() - first));
    for (int i = 0; i < count; ++i) packet.set(i, rays[first + static_cast<std::size_t>(i)]);
    shapes.template intersect<W>(packet, LaneSet::first(count), EmbreeTracer::Rays::kCoherent);
    for (int i = 0; i < count; ++i) hits[first + static_cast<std::size_t>(i)] = packet.hit(i);
  }
}

// As many as there are hits. `shapes`: an EmbreeTracer, or PosedShapes.
void intersectCoherent(const auto& shapes, std::span<const Ray> rays, std::span<Hit> hits) {
  if (instructionSet() == InstructionSet::kAvx512)
    intersectCoherent<16>(shapes, rays, hits);
  else
    intersectCoherent<8>(shapes, rays, hits);
}

}  // namespace saccade
