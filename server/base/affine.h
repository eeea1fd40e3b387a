// Affine maps in double precision, as columns.
#pragma once

#include <cmath>
#include <optional>

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

// None where the map is flat.
inline std::optional<Affine> inverse(const Affine& a) {
  const double size = determinant(a);
  const Vec3d x = cross(a.y, a.z) / size, y = cross(a.z, a.x) / size, z = cross(a.x, a.y) / size;
  Affine b{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}, {}};
  b.translation = -mapVector(b, a.translation);
  const double sum = dot(b.x, b.x) + dot(b.y, b.y) + dot(b.z, b.z) + dot(b.translation, b.translation);
  return std::isfinite(sum) ? std::optional(b) : std::nullopt;
}

// The map that applies b first, then a.
inline Affine operator*(const Affine& a, const Affine& b) {
  return {mapVector(a, b.x), mapVector(a, b.y), mapVector(a, b.z), mapPoint(a, b.translation)};
}

}  // namespace saccade
