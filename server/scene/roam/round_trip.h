// A closed path of straight lines between places of a tree.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/roam/space_tree.h"

namespace saccade {

// Its corners, of which the last is joined to the first. The seed draws so many stops, of 2 to 6, far from
// each other, and the trip visits them in the shortest order. All of its lines are clear.
std::vector<Vec3d> roundTrip(const FreeSpace& space, const std::vector<Place>& tree, double clearance,
                             std::size_t stops, std::uint64_t seed);

}  // namespace saccade
