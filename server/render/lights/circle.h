// Parts of a circle between planes.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace saccade {

// An interval of a circle's angles: `half` to both sides of `middle`, at most pi. The middle is in [-pi, pi].
struct Interval {
  double middle, half;
};

// Calls f(begin, end) for the parts of an interval that lie in another one.
void forEachCommon(Interval of, Interval other, const auto& f) {
  for (const double turn : {-2 * std::numbers::pi, 0., 2 * std::numbers::pi}) {
    const double begin = std::max(of.middle - of.half, other.middle - other.half + turn);
    const double end = std::min(of.middle + of.half, other.middle + other.half + turn);
    if (end > begin) f(begin, end);
  }
}

// The angles phi at which a + b cos(phi - middle) > 0. b: at least 0.
inline Interval positive(double a, double b, double middle) {
  return {middle, std::abs(a) < b ? std::acos(-a / b) : a > 0 ? std::numbers::pi : 0};
}

}  // namespace saccade
