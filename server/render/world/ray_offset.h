// How far off a surface rays start, so that rounding does not let them meet it again.
#pragma once

#include <limits>

#include "base/vec.h"

namespace saccade {

// Of a ray from `origin` that has met a shape at `point`, scene units. The point lies off the surface by
// rounding of both coordinates, and of the distances from the ray's origin to corners of a triangle. `edge`
// is the longest edge of the shape's triangles. The size of other shapes does not matter. [ours], after the
// bounds of Waechter and Binder 2019.
template <class F>
[[gnu::always_inline]] inline F rayOffset(const Vec3T<F>& origin, const Vec3T<F>& point, const F& edge) {
  using std::abs;
  constexpr float kRoundings = 8 * std::numeric_limits<float>::epsilon();
  return kRoundings *
         (edge + abs(origin.x) + abs(origin.y) + abs(origin.z) + abs(point.x) + abs(point.y) + abs(point.z));
}

}  // namespace saccade
