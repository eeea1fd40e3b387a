// Fresnel's equations for unpolarised light.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/lane.h"

namespace saccade {

struct Refraction {
  Lane reflectance;  // in [0, 1]
  Lane cos_t;        // of the refracted direction, in [0, 1]; 0 where all is reflected
};

// A dielectric, for light that arrives at cosine cos_i in [0, 1]; ior: the index of the other side over that
// of the side the light is on.
inline Refraction fresnelDielectric(Lane cos_i, Lane ior) {
  const Lane cos2_t = 1 - (1 - cos_i * cos_i) / (ior * ior);  // Snell
  const Lane cos_t = std::sqrt(std::max(Lane(0), cos2_t));
  const Lane s = (cos_i - ior * cos_t) / (cos_i + ior * cos_t);
  const Lane p = (ior * cos_i - cos_t) / (ior * cos_i + cos_t);
  return {select(cos2_t > 0, (s * s + p * p) / 2, Lane(1)), cos_t};
}

// A conductor of index eta + ik over that of the side the light is on [Born and Wolf, 14.2].
inline Lane fresnelConductor(Lane cos_i, Lane eta, Lane k) {
  constexpr Lane kTiny = 1e-30f;
  const Lane cos2 = cos_i * cos_i, sin2 = 1 - cos2;
  const Lane t = eta * eta - k * k - sin2;
  const Lane a2_b2 = std::sqrt(t * t + 4 * eta * eta * k * k);
  const Lane a_cos = 2 * cos_i * std::sqrt(std::max(Lane(0), (a2_b2 + t) / 2));
  const Lane s = (a2_b2 + cos2 - a_cos) / std::max(kTiny, a2_b2 + cos2 + a_cos);
  const Lane p_even = cos2 * a2_b2 + sin2 * sin2, p_odd = a_cos * sin2;
  return s * (1 + (p_even - p_odd) / std::max(kTiny, p_even + p_odd)) / 2;
}
inline LaneRgb fresnelConductor(Lane cos_i, LaneRgb eta, LaneRgb k) {
  return {fresnelConductor(cos_i, eta.x, k.x), fresnelConductor(cos_i, eta.y, k.y),
          fresnelConductor(cos_i, eta.z, k.z)};
}

}  // namespace saccade
