// Affine maps in double precision, as columns.
#pragma once

#include "base/vec.h"

namespace saccade {

struct Affine {
  Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, translation;
};

inline Vec3d mapVector(const Affine& a, Vec3d v) {
  return a.x * v.x + a.y * v.y + a.z * v.z;
}
inline Vec3d mapPoint(const Affine& a, Vec3d p) {
  return mapVector(a, p) + a.translation;
}

inline double determinant(const Affine& a) {
  return dot(a.x, cross(a.y, a.z));
}

// The map of normals: the inverse transpose times |determinant|, so that a flat map needs no division.
inline Vec3d mapNormal(const Affine& a, Vec3d n) {
  const Vec3d m = cross(a.y, a.z) * n.x + cross(a.z, a.x) * n.y + cross(a.x, a.y) * n.z;
  return determinant(a) < 0 ? -m : m;
}

// The map that applies b first, then a.
inline Affine operator*(const Affine& a, const Affine& b) {
  return {mapVector(a, b.x), mapVector(a, b.y), mapVector(a, b.z), mapPoint(a, b.translation)};
}

}  // namespace saccade
