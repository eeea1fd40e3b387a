// A point of a mesh, by its triangle, so that it is found again when the mesh has deformed.
#pragma once

#include "render/bsdf/shading_frame.h"
#include "render/world/patch.h"

namespace saccade {

// How far the point goes from one form of its mesh to another, in the space of the mesh. Exactly 0 where the
// vertices around it stay.
inline Vec3 stepOn(const Mesh& from, const Mesh& to, const ShapePoint& at) {
  const auto [i, j, k] = from.triangles[at.primitive];
  return interpolate(to.positions[i] - from.positions[i], to.positions[j] - from.positions[j],
                     to.positions[k] - from.positions[k], at.u, at.v);
}

// Axes that turn with the surface: its shading normal, and the first edge of the triangle at a right angle.
struct SurfaceAxes {
  SurfaceAxes(const Mesh& mesh, const ShapePoint& at) {
    const auto [i, j, k] = mesh.triangles[at.primitive];
    const Vec3 edge = mesh.positions[j] - mesh.positions[i];
    const Vec3 flat = cross(edge, mesh.positions[k] - mesh.positions[i]);
    normal = shadingNormalAt(mesh, at, dot(flat, flat) > 0 ? normalize(flat) : Vec3{0, 0, 1});
    const Vec3 across = cross(normal, edge);
    side = dot(across, across) > 0 ? normalize(across) : ShadingFrame<float>(normal).toWorld({1, 0, 0});
    along = cross(side, normal);
  }
  Vec3 inside(Vec3 d) const { return {dot(along, d), dot(side, d), dot(normal, d)}; }
  Vec3 outside(Vec3 d) const { return along * d.x + side * d.y + normal * d.z; }

  Vec3 along, side, normal;
};

// The direction d at a point of a mesh, turned as the surface has turned between two forms of the mesh.
inline Vec3 turnedWith(const Mesh& from, const Mesh& to, const ShapePoint& at, Vec3 d) {
  return SurfaceAxes(to, at).outside(SurfaceAxes(from, at).inside(d));
}

}  // namespace saccade
