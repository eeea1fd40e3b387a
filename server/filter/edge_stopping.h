// Edge-stopping weights as exponents of 2: w = h * 2^-(e_z + e_n + e_l). Each function returns the factor of
// its term, so that a weight takes one exponential.
//
// Against the paper's appendix:
// - [E (23)] divides |dz| by sigma_z |grad z . (p - q)| + eps. We divide by sigma_z times the largest
//   derivative times the distance |p - q| [Falcor], as the paper uses Falcor's defaults. It stops less
//   across a slope, and needs one plane less.
// - [E (24)] max(0, n.n')^sigma_n is written exp(-sigma_n (1 - n.n')) [ours]: equal to first order where the
//   weight is not already negligible, and it joins the common exponent.
// - [E (25)] is as it stands, with eps under the root.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "base/wide.h"

namespace saccade {

inline constexpr float kLog2E = std::numbers::log2e_v<float>;

// 2^whole, for whole numbers from -126 to 127; of floats or lanes.
inline float powerOfTwo(float whole) {
  return std::bit_cast<float>((static_cast<std::int32_t>(whole) + 127) << 23);
}
template <class Abi>
[[gnu::always_inline]] inline auto powerOfTwo(const stdx::simd<float, Abi>& whole) {
  using F = stdx::simd<float, Abi>;
  using I = stdx::rebind_simd_t<std::int32_t, F>;
  return std::bit_cast<F>((stdx::static_simd_cast<I>(whole) + 127) << 23);
}

// 2^x for x <= 0, to 0.35 %; 2^-126 below -126. Two additions, two products and a shift: it vectorises.
template <class F>
requires(!std::is_integral_v<F>) [[gnu::always_inline]] inline F fastExp2(F x) {
  using std::floor, std::max;
  x = max(x, F(-126.f));
  const F whole = floor(x), f = x - whole;
  return powerOfTwo(whole) * (1.f + f * (0.6565f + f * 0.3435f));
}
inline float fastExp2(float x) {
  return fastExp2<float>(x);
}

// The least slope of a surface, as a share of its depth per pixel. A wall seen head-on has dz = 0 up to
// rounding. kLeastSlope (0.006 degrees of view) keeps rounding from stopping the filter [ours]. Falcor's 1e-8
// scene units, here for a depth of 10, let it stop.
inline constexpr float kLeastSlope = 1e-4f, kFalcorLeastSlope = 1e-9f;

// Factor r_z(p): e_z = |z(p) - z(q)| * r_z(p) / |p - q|.
inline float depthFactor(float sigma_z, float z, float dz, float least_slope) {
  return kLog2E / (sigma_z * std::max(dz, least_slope * z));
}

// Factor r_l(p): e_l = |l(p) - l(q)| * r_l(p), from the blurred variance g_3x3(Var(l)) [E (25)].
inline float luminanceFactor(float sigma_l, float variance) {
  constexpr float kEpsilon = 1e-10f;  // [Falcor]
  return kLog2E / (sigma_l * std::sqrt(std::max(variance, 0.f) + kEpsilon));
}

}  // namespace saccade
