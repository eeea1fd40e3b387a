// The light of a disk in closed form.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/lane_vectors.h"
#include "render/lights/disk.h"
#include "render/lights/lamp_front.h"

namespace saccade {

struct LitPoint;

// The share of the cosine-weighted hemisphere above a point that a disk covers, as if nothing cast a shadow.
float diskFormFactor(const Disk& disk, const LitPoint& p);

// In the following functions, `to_center` leads from a point to the centre of a disk, or from several points.

template <class F>
[[gnu::always_inline]] inline auto seesDisk(const Vec3T<F>& to_center, const Disk& disk) {
  const float across = 2 * disk.radius;
  return isBefore<F>(-dot(to_center, splat<F>(disk.normal)), dot(to_center, to_center) + across * across);
}

// How far a disk reaches along n, from its centre.
template <class F>
[[gnu::always_inline]] inline F reachOf(const Disk& disk, const Vec3T<F>& n) {
  using std::max, std::sqrt;
  const F cosine = dot(n, splat<F>(disk.normal));
  return disk.radius * sqrt(max(F(0.f), 1.f - cosine * cosine));
}

// Of a disk above the horizon of n that shows its bright side. Hamilton and Morgan (1952) have the form
// factors of surfaces that lie parallel to a disk and at a right angle to it. They are the parts of a vector.
// With h the height above the disk's plane and e from below the point to the centre,
//   F = (2 h r^2 / Z) n (h a / (Z + s) + e / (Z + s + 2 r^2)),   s = h^2 + e^2 - r^2,   Z^2 = s^2 + 4 r^2 h^2
// where a is the unit vector across the plane. So written, nothing cancels out, if Z + s is 4 r^2 h^2 / (Z -
// s) where s < 0.
template <class F>
[[gnu::always_inline]] inline F wholeFormFactor(const Disk& disk, const Vec3T<F>& to_center,
                                                const Vec3T<F>& n) {
  using std::sqrt;
  const Vec3T<F> lit = splat<F>(disk.normal);
  const F h = -dot(to_center, lit), r2 = disk.radius * disk.radius;
  const Vec3T<F> e = to_center + lit * h;
  const F s = h * h + dot(e, e) - r2, Z = sqrt(s * s + 4.f * r2 * h * h);
  const F across = select(s < 0.f, F((Z - s) / (4.f * r2 * h)), F(h / (Z + s)));
  return 2.f * h * r2 / Z * (dot(n, e) / (Z + s + 2.f * r2) - dot(n, lit) * across);
}

}  // namespace saccade
