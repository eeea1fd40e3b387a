// What a bake keeps at a vertex. It is small, because frames read it here and there in a large memory.
#pragma once

#include <immintrin.h>

#include <bit>
#include <cstdint>

#include "cache/lanes.h"

namespace saccade {

// The upper half of a float: the nearest number of three digits. It suffices for variances.
class HalfFloat {
 public:
  HalfFloat() = default;
  explicit HalfFloat(float v)
      : bits_(static_cast<std::uint16_t>((std::bit_cast<std::uint32_t>(v) + 0x8000) >> 16)) {}
  float value() const { return std::bit_cast<float>(std::uint32_t{bits_} << 16); }
  bool hasSign() const { return bits_ >> 15 != 0; }

 private:
  std::uint16_t bits_ = 0;
};

// The light of one level. Variances are those of rest and visibility, and those of a step over the length of
// a cell if they went on growing with its square. What is not known is 0, and has a sign in one of them.
struct alignas(16) BakedVertex {
  bool isKnown() const { return !step_rest.hasSign(); }

  float rest = 0, visibility = 0;
  HalfFloat var_rest = {}, var_visibility = {}, step_rest = HalfFloat(-0.f), step_visibility = {};
};
inline BakedVertex meanOf(const BakedVertex& a, const BakedVertex& b) {
  const auto mean = [](HalfFloat x, HalfFloat y) { return HalfFloat(0.5f * (x.value() + y.value())); };
  return {0.5f * (a.rest + b.rest),       0.5f * (a.visibility + b.visibility),
          mean(a.var_rest, b.var_rest),   mean(a.var_visibility, b.var_visibility),
          mean(a.step_rest, b.step_rest), mean(a.step_visibility, b.step_visibility)};
}

// The light of a level at one of its vertices, and that of the next coarser level there.
struct alignas(32) BakedPair {
  BakedVertex fine, coarse;
};
static_assert(sizeof(BakedPair) == 32);

// The lanes of the light around a point. kKnown is the share of its weights that is on known vertices, and
// the fourth mean says nothing. Lanes of the coarser level come kOfCoarse later.
enum BakedMean { kRest, kVisibility, kKnown };
enum BakedVariance { kVarRest, kVarVisibility, kStepRest, kStepVisibility };
inline constexpr int kOfCoarse = 4;

struct BakedSums {
  void add(const BakedPair& vertex, Octet weights) {
    const __m256i bits = _mm256_load_si256(reinterpret_cast<const __m256i*>(&vertex));
    const __m256i half_floats = _mm256_unpackhi_epi16(__m256i{}, bits);
    static_assert(int{kKnown} == int{kStepRest});  // whose sign tells
    const __m256i unknown = _mm256_srai_epi32(half_floats, 31);
    const __m256 known = _mm256_andnot_ps(_mm256_castsi256_ps(unknown), _mm256_set1_ps(1));
    constexpr int kKnownLanes = 1 << kKnown | 1 << (kOfCoarse + kKnown);
    means += Octet(_mm256_blend_ps(_mm256_castsi256_ps(bits), known, kKnownLanes)) * weights;
    variances += Octet(_mm256_castsi256_ps(half_floats)) * weights;
  }

  Octet means{}, variances{};
};

}  // namespace saccade
