// The distance from a point to a triangle.
#pragma once

#include "base/vec.h"

namespace saccade {

// Of any triangle: one that is thin, or without area, is never taken to be farther away than it is.
double triangleDistance(Vec3d point, Vec3d a, Vec3d b, Vec3d c);

}  // namespace saccade
