// Visible slopes of a Beckmann surface of roughness 1.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/vec.h"

namespace saccade {

// The inverse of erf on (-1, 1). Its relative error is 4e-7 [Giles 2010].
inline float inverseErf(float x) {
  constexpr float kCentre[] = {2.81022636e-08f,  3.43273939e-07f, -3.5233877e-06f,
                               -4.39150654e-06f, 0.00021858087f,  -0.00125372503f,
                               -0.00417768164f,  0.246640727f,    1.50140941f};
  constexpr float kTail[] = {-0.000200214257f, 0.000100950558f, 0.00134934322f,
                             -0.00367342844f,  0.00573950773f,  -0.0076224613f,
                             0.00943887047f,   1.00167406f,     2.83297682f};
  const float w = -std::log((1 - x) * (1 + x));
  const bool tail = w >= 5;
  const float v = tail ? std::sqrt(w) - 3 : w - 2.5f;
  float p = 0;
  for (int i = 0; i < 9; ++i) p = p * v + (tail ? kTail[i] : kCentre[i]);
  return p * x;
}

struct Slope {
  float x, y;
};

// The slope of a microfacet, seen in the xz plane from cosine cos_v > 0. x points to the side of the viewer.
// Newton's method finds the slope's x in the domain of erf [Jakob 2014]. Its y is normally distributed.
inline Slope sampleBeckmannSlope(float cos_v, float u1, float u2) {
  constexpr float kEdge = 1e-6f, kInvSqrtPi = std::numbers::inv_sqrtpi_v<float>;
  const float tan_v = std::sqrt(std::max(1e-12f, 1 - cos_v * cos_v)) / cos_v;
  const float cot_v = 1 / tan_v, end = std::erf(cot_v);
  const float u = std::clamp(u1, kEdge, 1 - kEdge);
  const float cdf = u * (1 + end + kInvSqrtPi * tan_v * std::exp(-cot_v * cot_v));
  float x = end - (end + 1) * std::erf(std::sqrt(-std::log(u)));  // exact at grazing angles
  for (int i = 0; i < 3; ++i) {
    x = std::clamp(x, kEdge - 1, std::min(end, 1 - kEdge));
    const float slope = inverseErf(x);
    const float excess = 1 + x + kInvSqrtPi * tan_v * std::exp(-slope * slope) - cdf;
    x -= excess / std::max(kEdge, 1 - slope * tan_v);
  }
  x = std::clamp(x, kEdge - 1, std::min(end, 1 - kEdge));
  return {inverseErf(x), inverseErf(std::clamp(2 * u2 - 1, kEdge - 1, 1 - kEdge))};
}

}  // namespace saccade
