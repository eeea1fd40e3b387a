// Directions in the shading frame, and the choice between lobes.
#pragma once

#include <algorithm>
#include <numbers>

#include "base/lane.h"

namespace saccade {

inline constexpr float kInvPi = std::numbers::inv_pi_v<float>;
inline constexpr float kLeastLobeProbability = 0.05f;

// Cosine-weighted over the upper hemisphere: polar map to the disk.
inline LaneVec3 cosineHemisphere(Lane u1, Lane u2) {
  const Lane r = std::sqrt(u1), phi = 2 * std::numbers::pi_v<float> * u2;
  return {r * std::cos(phi), r * std::sin(phi), std::sqrt(std::max(Lane(0), 1 - u1))};
}

// pdf per solid angle of a cosine-weighted direction at cosine cos_n.
inline Lane cosinePdf(Lane cos_n) {
  return std::max(Lane(0), cos_n) * kInvPi;
}

// w mirrored about the normal.
inline LaneVec3 mirror(LaneVec3 w) {
  return {-w.x, -w.y, w.z};
}

// w mirrored about the unit vector m.
inline LaneVec3 mirror(LaneVec3 w, LaneVec3 m) {
  return m * (2 * dot(w, m)) - w;
}

// Probability of the first of two lobes that reflect this much: a lobe that exists is never starved, so that
// light it alone carries is found.
inline Lane lobeProbability(Lane first, Lane second) {
  const Lane p = std::clamp(first / (first + second), kLeastLobeProbability, 1 - kLeastLobeProbability);
  return select(first <= 0, Lane(0), select(second <= 0, Lane(1), p));
}

}  // namespace saccade
