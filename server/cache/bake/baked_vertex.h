// The values that a bake keeps at a vertex. They are small, because frames read them here and there in a
// large memory.
#pragma once

#include <immintrin.h>

#include <algorithm>
#include <bit>
#include <cstdint>

#include "cache/lattice/lanes.h"

namespace saccade {

// The light of one level at a vertex. Variances are those of residual and visibility. Variances of a step are
// extrapolated with its square to the length of a cell. `shadow`: the variance of visibility within the
// finest cells and of its mean; 0 where it can change no light visibly.
struct BakedVertex {
  bool known = false;
  float residual = 0, visibility = 0;
  float var_residual = 0, var_visibility = 0, step_residual = 0, step_visibility = 0;
  float shadow = 0;
};
// Of two that are known.
inline BakedVertex meanOf(const BakedVertex& a, const BakedVertex& b) {
  const auto mean = [&](float BakedVertex::*member) { return 0.5f * (a.*member + b.*member); };
  using V = BakedVertex;
  return {true,
          mean(&V::residual),
          mean(&V::visibility),
          mean(&V::var_residual),
          mean(&V::var_visibility),
          mean(&V::step_residual),
          mean(&V::step_visibility),
          mean(&V::shadow)};
}

// A byte that stands for a variance: the nearest of four numbers to each power of two, from 2^-48 to 2^16.
class VarianceByte {
 public:
  VarianceByte() = default;
  explicit VarianceByte(float v)
      : code_(static_cast<std::uint8_t>(std::clamp(
            static_cast<int>((std::bit_cast<std::uint32_t>(v) + kHalf) >> kShift) - kLeast, 0, 255))) {}
  float value() const { return std::bit_cast<float>(static_cast<std::uint32_t>(code_ + kLeast) << kShift); }
  // Of eight bytes at the end of `bits`.
  static Octet values(__m128i bits) {
    const __m256i codes = _mm256_cvtepu8_epi32(_mm_unpackhi_epi64(bits, bits));
    return _mm256_castsi256_ps(_mm256_slli_epi32(_mm256_add_epi32(codes, _mm256_set1_epi32(kLeast)), kShift));
  }

 private:
  static constexpr int kShift = 21, kLeast = (127 - 48) << 2;  // of the bits of a float
  static constexpr std::uint32_t kHalf = 1 << (kShift - 1);

  std::uint8_t code_ = 0;
};

// The light of a level at one of its vertices, and that of the next coarser level there, without `shadow`.
// Rest and visibility are half floats (IEEE 754 binary16); their errors of 2^-12 are a thousandth of a usual
// contrast threshold.
class alignas(16) BakedPair {
 public:
  BakedPair() : BakedPair({}, {}) {}
  BakedPair(const BakedVertex& fine, const BakedVertex& coarse) {
    // Where nothing is known, visibility has a sign.
    const auto visibility = [](const BakedVertex& v) { return v.known ? std::max(v.visibility, 0.f) : -0.f; };
    const __m128 all = _mm_setr_ps(fine.residual, visibility(fine), coarse.residual, visibility(coarse));
    means_ = std::bit_cast<Means>(_mm_cvtsi128_si64(_mm_cvtps_ph(all, _MM_FROUND_TO_NEAREST_INT)));
    const auto pack = [](const BakedVertex& v) {
      return Variances{VarianceByte(v.var_residual), VarianceByte(v.var_visibility),
                       VarianceByte(v.step_residual), VarianceByte(v.step_visibility)};
    };
    variances_ = {pack(fine), pack(coarse)};
  }
  // The finer lights of two.
  static BakedPair ofFine(const BakedPair& fine, const BakedPair& coarse) {
    BakedPair both;
    both.means_ = {fine.means_[0], coarse.means_[0]};
    both.variances_ = {fine.variances_[0], coarse.variances_[0]};
    return both;
  }

  BakedVertex fine() const { return unpacked(0); }
  BakedVertex coarse() const { return unpacked(1); }
  __m128i bits() const { return _mm_load_si128(reinterpret_cast<const __m128i*>(this)); }

 private:
  struct Mean {
    std::uint16_t residual, visibility;
  };
  using Means = std::array<Mean, 2>;
  using Variances = std::array<VarianceByte, 4>;

  BakedVertex unpacked(int i) const {
    const Mean& mean = means_[i];
    const auto& [var_residual, var_visibility, step_residual, step_visibility] = variances_[i];
    return {mean.visibility >> 15 == 0, _cvtsh_ss(mean.residual), _cvtsh_ss(mean.visibility),
            var_residual.value(),       var_visibility.value(),   step_residual.value(),
            step_visibility.value()};
  }

  Means means_;
  std::array<Variances, 2> variances_;
};
static_assert(sizeof(BakedPair) == 16);

// The lanes of the light around a point. kKnown is the share of its weights on known vertices; the fourth
// mean has no meaning. Lanes of the coarser level come kOfCoarse later.
enum BakedMean { kResidual, kVisibility, kKnown };
enum BakedVariance { kVarResidual, kVarVisibility, kStepResidual, kStepVisibility };
inline constexpr int kOfCoarse = 4;

struct BakedSums {
  void add(const BakedPair& vertex, Octet weights) {
    const __m128i bits = vertex.bits();
    const __m256i lanes = _mm256_setr_epi32(0, 1, 1, 1, 2, 3, 3, 3);  // of residual, visibility and its sign
    const __m256 both = _mm256_permutevar8x32_ps(_mm256_castps128_ps256(_mm_cvtph_ps(bits)), lanes);
    const __m256i unknown = _mm256_srai_epi32(_mm256_castps_si256(both), 31);
    const __m256 known = _mm256_andnot_ps(_mm256_castsi256_ps(unknown), _mm256_set1_ps(1));
    constexpr int kKnownLanes = 1 << kKnown | 1 << (kOfCoarse + kKnown);
    means += Octet(_mm256_blend_ps(both, known, kKnownLanes)) * weights;
    variances += VarianceByte::values(bits) * weights;
  }

  Octet means{}, variances{};
};

}  // namespace saccade
