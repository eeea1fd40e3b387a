// exp(-a) and its divided difference, for loops that the compiler turns into vectors.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace saccade {

// exp(-a) for a >= 0, relative error below 1e-6; a above 80 counts as 80.
inline float decay(float a) {
  constexpr float kLog2 = 0x1.62e430p-1f, kInvLog2 = 0x1.715476p+0f;
  const float exponent = -std::min(a, 80.f) * kInvLog2;
  const auto k = static_cast<std::int32_t>(exponent - 0.5f);   // towards 0: the nearest
  const float r = (exponent - static_cast<float>(k)) * kLog2;  // |r| <= log(2) / 2
  const float series =
      1 + r * (1 + r * (1.f / 2 + r * (1.f / 6 + r * (1.f / 24 + r * (1.f / 120 + r / 720)))));
  return series * std::bit_cast<float>((k + 127) << 23);
}

// (exp(-a) - exp(-b)) / (b - a) for a, b >= 0; exp(-a) where a = b.
inline float decayBetween(float a, float b) {
  const float half = (b - a) / 2, h2 = half * half;
  // exp(-(a + b) / 2) sinh(h) / h, whose series leaves out 3e-6 of it at |h| = 1/2.
  const float near = decay((a + b) / 2) * (1 + h2 * (1.f / 6 + h2 * (1.f / 120)));
  const float far = (decay(a) - decay(b)) / (b - a);
  return std::abs(half) < 0.5f ? near : far;
}

}  // namespace saccade
