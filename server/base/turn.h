// Sine and cosine of parts of a turn, for floats and for lanes of floats (wide.h).
#pragma once

#include <cmath>

#include "base/wide.h"

namespace saccade {

template <class F>
struct SinCos {
  F sin, cos;
};

// Takes the angle 2 pi u, for u in [0, 1]. The error is below 2e-7: the Taylor polynomials are of angles up
// to pi / 4. Swapping and negating add quarters of a turn.
template <class F>
[[gnu::always_inline]] inline SinCos<F> sinCosOfTurn(F u) {
  using std::floor;
  const F quarter = floor(u * 4.f + 0.5f);
  const F a = (u * 4.f - quarter) * 1.57079633f, a2 = a * a;
  const F s = a * (1.f + a2 * (-1.f / 6 + a2 * (1.f / 120 + a2 * (-1.f / 5040 + a2 * (1.f / 362880)))));
  const F c = 1.f + a2 * (-0.5f + a2 * (1.f / 24 + a2 * (-1.f / 720 + a2 * (1.f / 40320))));
  const auto odd = quarter == 1.f || quarter == 3.f;
  const auto sin_below = quarter == 2.f || quarter == 3.f, cos_below = quarter == 1.f || quarter == 2.f;
  const F sine = select(odd, c, s), cosine = select(odd, s, c);
  return {select(sin_below, -sine, sine), select(cos_below, -cosine, cosine)};
}

}  // namespace saccade
