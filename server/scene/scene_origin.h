// Scenes in map coordinates: floats are too coarse far from 0.
#pragma once

#include "scene/scene.h"

namespace saccade {

// Where the origin of a scene's axes should lie, for a scene that was read with its origin at 0. A coordinate
// is 0 unless the scene's centre is more than 128 of its diagonals away from 0 along that axis. An ulp of a
// position is then as large as the step by which rays leave surfaces. Else it is the centre, rounded to a
// multiple of the power of two above the diagonal.
Vec3d originOf(const Scene& scene);

}  // namespace saccade
