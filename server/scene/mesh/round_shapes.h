// Round shapes as meshes, with Mitsuba's texture coordinates and the normals of the round shape.
#pragma once

#include "scene/scene.h"

namespace saccade {

// Corners round an axis. The shape is inscribed, so that its area is about 1e-4 too small.
inline constexpr int kRoundCorners = 256;

// Radius 1 around the z axis from z = 0 to 1, open at both ends; normals outwards. In uv, u is the angle from
// +x to +y in turns, and v is z.
Mesh makeCylinder();

// Radius 1 around 0; normals outwards. In uv, u is the angle around the z axis from +x to +y in turns, and v
// that from +z, over pi.
Mesh makeSphere();

}  // namespace saccade
