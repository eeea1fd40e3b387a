// Fresnel's equations for unpolarised light.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/vec.h"
#include "base/wide.h"

namespace saccade {

template <class F>
struct Refraction {
  F reflectance;  // in [0, 1]
  F cos_t;        // of the refracted direction, in [0, 1]; 0 where all is reflected
};

// The reflectance of a dielectric, for light from cosine cos_i in [0, 1]. `ior` is the index of the other
// side over that of the light's side.
template <class F>
Refraction<F> fresnelDielectric(F cos_i, F ior) {
  using std::max, std::sqrt;
  const F cos2_t = 1.f - (1.f - cos_i * cos_i) / (ior * ior);  // Snell
  const F cos_t = sqrt(max(F(0.f), cos2_t));
  const F s = (cos_i - ior * cos_t) / (cos_i + ior * cos_t);
  const F p = (ior * cos_i - cos_t) / (ior * cos_i + cos_t);
  const F mean = (s * s + p * p) * 0.5f;
  return {select(cos2_t > 0.f, mean, F(1.f)), cos_t};
}

// The reflectance of a conductor. Its index eta + ik is relative to that of the light's side [Born and Wolf,
// 14.2].
inline float fresnelConductor(float cos_i, float eta, float k) {
  constexpr float kTiny = 1e-30f;
  const float cos2 = cos_i * cos_i, sin2 = 1 - cos2;
  const float t = eta * eta - k * k - sin2;
  const float a2_b2 = std::sqrt(t * t + 4 * eta * eta * k * k);
  const float a_cos = 2 * cos_i * std::sqrt(std::max(0.f, (a2_b2 + t) / 2));
  const float s = (a2_b2 + cos2 - a_cos) / std::max(kTiny, a2_b2 + cos2 + a_cos);
  const float p_even = cos2 * a2_b2 + sin2 * sin2, p_odd = a_cos * sin2;
  return s * (1 + (p_even - p_odd) / std::max(kTiny, p_even + p_odd)) / 2;
}
inline Rgb fresnelConductor(float cos_i, Rgb eta, Rgb k) {
  return {fresnelConductor(cos_i, eta.x, k.x), fresnelConductor(cos_i, eta.y, k.y),
          fresnelConductor(cos_i, eta.z, k.z)};
}

}  // namespace saccade
