// Paths begin at plain surfaces, in lanes.
#pragma once

#include "render/paths/path_planes.h"
#include "render/paths/path_state.h"
#include "render/primary/primary_block.h"

namespace saccade {

// Adds a path for each lane of a set, all but its random numbers and its slot. There must be room for them.
// `mixed`: surfaces of the scene are not all diffuse, or let light through.
template <int C>
void beginPlain(const PlainSurfaces& s, LaneSet lanes, float spread, bool mixed, LivePaths<C>& to) {
  constexpr int kLanes = 8;
  for (int first = 0; first < kLaneVectors; first += kLanes) {
    const LaneSet here = lanes.from(first) & LaneSet::first(kLanes);
    if (!here.any()) continue;
    const auto at = static_cast<std::size_t>(to.count);
    const auto keep = [&](const float* from, Plane& plane) {
      compress(here, load<kLanes>(from + first), &plane[at]);
    };
    const auto keepVectors = [&](const LaneVectors& from, VectorPlanes& planes) {
      keep(from.x, planes.x), keep(from.y, planes.y), keep(from.z, planes.z);
    };
    const auto set = [&](float value, Plane& plane) {
      Floats<kLanes>(value).copy_to(&plane[at], stdx::element_aligned);
    };
    const Floats<kLanes> offset = load<kLanes>(s.offset + first);
    LaneVectors origin;
    origin.store(s.point.lanes<kLanes>(first) + s.geometric_normal.lanes<kLanes>(first) * offset, first);
    keepVectors(origin, to.origin);
    keepVectors(s.geometric_normal, to.geometric_normal), keepVectors(s.shading_normal, to.shading_normal);
    if constexpr (C == 1) keep(s.albedo, to.reflectance.of[0]);
    if constexpr (C == 3)
      keep(s.reflectance.x, to.reflectance.of[0]), keep(s.reflectance.y, to.reflectance.of[1]),
          keep(s.reflectance.z, to.reflectance.of[2]);
    for (Plane& plane : to.throughput.of) set(1, plane);
    keep(s.width, to.width), set(spread, to.spread);
    if (mixed) {
      const std::uint32_t state = PathState{0, true, true, true, false, ShadedAs::kDiffuse}.pack();
      std::fill_n(&to.state[at], kLanes, state);
      set(1, to.pdf), set(0, to.distance);
    }
    to.count += here.size();
  }
}

}  // namespace saccade
