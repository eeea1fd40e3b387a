// Rounds the corners of a closed path within the free space.
#pragma once

#include <vector>

#include "scene/camera/free_space.h"

namespace saccade {

// So many points along the path through `corners`, which were even before they were moved. Each moves towards
// its neighbours, again and again. It stops where it would come nearer to a surface than `clearance` and the
// way between two points, or than it was.
std::vector<Vec3d> roundedTrip(const FreeSpace& space, const std::vector<Vec3d>& corners, double clearance,
                               std::size_t points);

}  // namespace saccade
