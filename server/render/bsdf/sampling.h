// Directions in the shading frame, and the choice between lobes.
#pragma once

#include <algorithm>
#include <numbers>

#include "base/turn.h"
#include "base/vec.h"

namespace saccade {

inline constexpr float kInvPi = std::numbers::inv_pi_v<float>;
inline constexpr float kLeastLobeProbability = 0.05f;

// Cosine-weighted over the upper hemisphere: polar map to the disk.
template <class F>
Vec3T<F> cosineHemisphere(F u1, F u2) {
  using std::sqrt;
  const F r = sqrt(u1);
  const auto [sine, cosine] = sinCosOfTurn(u2);
  return {r * cosine, r * sine, sqrt(1.f - u1)};
}

// pdf per solid angle of a cosine-weighted direction at cosine cos_n.
template <class F>
F cosinePdf(F cos_n) {
  using std::max;
  return max(F(0), cos_n) * kInvPi;
}

// w mirrored about the normal.
inline Vec3 mirror(Vec3 w) {
  return {-w.x, -w.y, w.z};
}

// w mirrored about the unit vector m.
inline Vec3 mirror(Vec3 w, Vec3 m) {
  return m * (2 * dot(w, m)) - w;
}

// The probability of the first of two lobes that reflect this much. No lobe that reflects light gets too low
// a probability, because it may be the only one to carry some light.
inline float lobeProbability(float first, float second) {
  const float p = std::clamp(first / (first + second), kLeastLobeProbability, 1 - kLeastLobeProbability);
  return first <= 0 ? 0.f : second <= 0 ? 1.f : p;
}

}  // namespace saccade
