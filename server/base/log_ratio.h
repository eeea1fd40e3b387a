// The logarithm of the lin-log response, for loops that the compiler turns into vectors.
#pragma once

#include <bit>
#include <cstdint>

namespace saccade {

inline constexpr float kMaxLuminance = 1e18f;

// `v` clamped to [lo, hi]; NaN stays NaN.
inline float clampTo(float v, float lo, float hi) {
  return v < lo ? lo : v > hi ? hi : v;
}

// log(b / a) for a, b > 0 and change = b - a, relative error below 1e-6; exactly 0 where nothing changes.
//
// log(b / a) = k log 2 + 2 atanh(s), s = (b - a 2^k) / (b + a 2^k). There b / (a 2^k) lies in [sqrt(1/2),
// sqrt 2]. For small changes k is 0 and the numerator b - a is the change itself: nothing cancels.
inline float logRatio(float a, float b, float change) {
  constexpr float kLog2 = 0x1.62e430p-1f;
  constexpr std::uint32_t kOne = 0x3f800000, kSqrtHalf = 0x3f3504f3;  // 1 and sqrt(1/2) as bits
  const std::uint32_t ratio = std::bit_cast<std::uint32_t>(b / a);
  const std::uint32_t exponent = (ratio - kSqrtHalf) & 0xff800000;  // k, in place
  const float scaled = a * std::bit_cast<float>(exponent + kOne);
  const float s = (exponent == 0 ? change : b - scaled) / (b + scaled);
  // |s| <= 0.172: the first term left out is 2e-9 of the first.
  const float s2 = s * s;
  const float series = 2 * s * (1 + s2 * (1.f / 3 + s2 * (1.f / 5 + s2 * (1.f / 7 + s2 * (1.f / 9)))));
  return static_cast<float>(static_cast<std::int32_t>(exponent) >> 23) * kLog2 + series;
}

// log(I_eps + I) [E (1)], with I clamped to [0, kMaxLuminance]; NaN stays NaN.
inline float logBrightness(float I, float I_eps) {
  const float response = I_eps + clampTo(I, 0, kMaxLuminance);
  return logRatio(1, response, response - 1);
}

// The same, with 0 for an I that is NaN or Inf.
inline float finiteLogBrightness(float I, float I_eps) {
  return logBrightness(I - I == 0 ? I : 0, I_eps);
}

}  // namespace saccade
