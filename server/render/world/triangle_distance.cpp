#include "render/world/triangle_distance.h"

#include <algorithm>
#include <cmath>

namespace saccade {
namespace {

// The square of the distance from the origin to the line between two points.
double toSide(Vec3d from, Vec3d to) {
  const Vec3d side = to - from;
  const double whole = dot(side, side);
  const double share = whole > 0 ? std::clamp(-dot(from, side) / whole, 0.0, 1.0) : 0;
  const Vec3d nearest = from + side * share;
  return dot(nearest, nearest);
}

}  // namespace

double triangleDistance(Vec3d point, Vec3d a, Vec3d b, Vec3d c) {
  const Vec3d p = a - point, q = b - point, r = c - point;
  double nearest = std::min({toSide(p, q), toSide(q, r), toSide(r, p)});
  const Vec3d normal = cross(q - p, r - p);
  const auto isWithin = [&](Vec3d from, Vec3d to) { return dot(cross(from, to), normal) > 0; };
  if (isWithin(p, q) && isWithin(q, r) && isWithin(r, p)) {  // the foot on its plane lies in it
    const double height = dot(p, normal);
    nearest = std::min(nearest, height * height / dot(normal, normal));
  }
  return std::sqrt(nearest);
}

}  // namespace saccade
