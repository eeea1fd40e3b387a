// Whether a line keeps its distance from all surfaces, all along.
#pragma once

#include <vector>

#include "scene/camera/free_space.h"

namespace saccade {

// Both hold within a twentieth of the clearance: a line that is clear by 1.05 of it keeps it everywhere. They
// ask at most some hundred questions of a segment or a span, and take a line for blocked that needs more.
bool isClear(const FreeSpace& space, Vec3d from, Vec3d to, double clearance);

// Of the closed spline loopAt().
bool isLoopClear(const FreeSpace& space, const std::vector<Vec3d>& controls, double clearance);

}  // namespace saccade
