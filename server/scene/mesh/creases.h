// Smooth normals that stop at edges, as by maxSmoothAngle of Mitsuba 0.6.
#pragma once

#include "base/affine.h"
#include "scene/scene.h"

namespace saccade {

// Vertices of equal place and texture coordinates become one for each group of faces around them. The normals
// of a group, once `to_world` has placed them, are less than `degrees` from that of its first face. At a
// vertex with many groups further faces have one each. Drops the normals of the mesh: placeMesh() makes them
// anew.
void splitAtCreases(Mesh& mesh, const Affine& to_world, double degrees);

}  // namespace saccade
