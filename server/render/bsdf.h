// The diffuse BSDF: free functions over lanes, no branches on them.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/lane.h"
#include "base/vec.h"

namespace saccade {

inline constexpr float kInvPi = std::numbers::inv_pi_v<float>;

struct DirectionSample {
  Vec3T<Lane> direction;
  Lane pdf;  // per solid angle
};

// Cosine-weighted about the unit vector n: the pdf is cos/pi, so that f * cos / pdf is the albedo.
inline DirectionSample sampleCosine(Vec3T<Lane> n, Lane u1, Lane u2) {
  // Polar map to the disk; basis without a singularity (Duff et al. 2017).
  const Lane r = std::sqrt(u1), phi = 2 * std::numbers::pi_v<float> * u2;
  const Lane x = r * std::cos(phi), y = r * std::sin(phi), z = std::sqrt(std::max(Lane(0), 1 - u1));
  const Lane sign = std::copysign(Lane(1), n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
  const Vec3T<Lane> s{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, t{b, sign + n.y * n.y * a, -n.y};
  return {s * x + t * y + n * z, z * kInvPi};
}

// pdf of sampleCosine() for a direction at cosine cos_n.
inline Lane cosinePdf(Lane cos_n) {
  return std::max(Lane(0), cos_n) * kInvPi;
}

// Balance heuristic (Veach 1995).
inline Lane balance(Lane pdf, Lane other) {
  return pdf / (pdf + other);
}

}  // namespace saccade
