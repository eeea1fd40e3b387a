// Formulas of features, of one pixel or of lanes of pixels: F is a float or lanes.
#pragma once

#include "base/wide.h"
#include "render/camera/camera.h"

namespace saccade {

template <class F>
struct ImageMotion {
  F x, y;  // pixels
};

// Both projections use the same formula, so that a standing camera gives exactly 0.
template <class F>
[[gnu::always_inline]] inline ImageMotion<F> motionBetween(const Camera::ProjectionT<F>& now,
                                                           const Camera::ProjectionT<F>& before) {
  constexpr float kFarOutside = 1e6f;  // behind the previous camera
  const auto seen = before.z > 0.f;
  return {select(seen, F(before.x - now.x), F(kFarOutside)),
          select(seen, F(before.y - now.y), F(kFarOutside))};
}

// max(|dz/dx|, |dz/dy|) of the plane through `offset` (from the camera) with normal n, at depth z. `right`
// and `down`: directions of the next rays, see Camera::nextRight().
template <class F>
[[gnu::always_inline]] inline F planeSlope(const Vec3T<F>& right, const Vec3T<F>& down,
                                           const Vec3T<F>& offset, const Vec3T<F>& n, const F& z) {
  using std::abs, std::max;
  const F height = dot(offset, n);
  const auto step = [&](const Vec3T<F>& next) { return F(abs(height / dot(next, n) - z)); };
  const F dz = max(step(right), step(down));
  return select(dz < z, dz, z);  // also if the next ray is parallel to the plane
}

}  // namespace saccade
