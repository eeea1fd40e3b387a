// Flat convex polygons, seen from the origin.
#pragma once

#include <array>

#include "base/vec.h"

namespace saccade {

struct Polygon {
  static constexpr std::size_t kMaxCorners = 8;
  std::array<Vec3, kMaxCorners> corners;
  std::size_t count = 0;
  void add(Vec3 v) {
    if (count < kMaxCorners) corners[count++] = v;
  }
};

// The part of a polygon that is above the plane through the origin with normal n.
inline Polygon above(const Polygon& in, Vec3 n) {
  bool all = true;
  for (std::size_t i = 0; i < in.count; ++i) all = all && dot(in.corners[i], n) > 0;
  if (all) return in;
  Polygon out;
  for (std::size_t i = 0; i < in.count; ++i) {
    const Vec3 a = in.corners[i], b = in.corners[i + 1 < in.count ? i + 1 : 0];
    const float height_a = dot(a, n), height_b = dot(b, n);
    if (height_a > 0) out.add(a);
    if ((height_a > 0) != (height_b > 0)) out.add(a + (b - a) * (height_a / (height_a - height_b)));
  }
  return out;
}

}  // namespace saccade
