// Makes meshes from formulas, with Mitsuba's texture coordinates, and places meshes in a scene.
#pragma once

#include "base/affine.h"
#include "scene/scene.h"

namespace saccade {

// [-1, 1]^2 at z = 0, normal +z, uv in [0, 1]^2.
Mesh makeRectangle();

// [-1, 1]^3, normals outwards, each face with uv in [0, 1]^2.
Mesh makeCube();

// The disk of radius 1 at z = 0, normal +z, as a polygon inscribed in it; its area is 1e-4 too small. In uv,
// u is the radius, and v the angle from +x to +y in turns.
inline constexpr int kDiskCorners = 256;
Mesh makeDisk();

// Maps the mesh to the world and gives it the spare position that Embree reads. The normals become unit
// length; where the mesh has none they are the angle-weighted means of the faces around each vertex;
// `face_normals` drops them. A map that mirrors turns the triangles round, so that they still face where
// their normals point.
void placeMesh(Mesh& mesh, const Affine& to_world, bool face_normals);

// Makes the mesh face the other way.
void turnRound(Mesh& mesh);

}  // namespace saccade
