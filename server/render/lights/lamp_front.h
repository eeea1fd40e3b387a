// The bright side of flat lamps.
#pragma once

#include <span>

#include "base/lane_vectors.h"

namespace saccade {

// Whether a point is on the bright side of a lamp, at this height above its plane. A point in the plane is
// not, such as one of the lamp's own back: rounding alone moves it this much off. `size2`: squared distances
// to the lamp and across it.
template <class F>
[[gnu::always_inline]] inline auto isBefore(const F& height, const F& size2) {
  constexpr float kLeastSine = 1e-4f;
  return height > 0.f && height * height > kLeastSine * kLeastSine * size2;
}

// Whether a point sees the bright side of a polygon.
template <class F>
[[gnu::always_inline]] inline auto seesLamp(const Vec3T<F>& point, std::span<const Vec3> corners, Vec3 lit) {
  const auto diagonal = corners[2] - corners[0];
  const Vec3T<F> to_point = point - splat<F>(corners[0]);
  return isBefore<F>(dot(to_point, splat<F>(lit)), dot(to_point, to_point) + dot(diagonal, diagonal));
}

}  // namespace saccade
