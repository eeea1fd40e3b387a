// What a bake keeps at a vertex. It is small, because frames read it here and there in a large memory.
#pragma once

#include <immintrin.h>

#include <bit>
#include <cstdint>

#include "cache/lanes.h"

namespace saccade {

// The lanes of the light around a point. kKnown is the share of its weights that is on known vertices, and
// one lane means nothing. Variances are those of rest and visibility, and those of a step over the length of
// a cell if they went on growing with its square.
enum BakedLane { kRest, kVisibility, kKnown, kUnused, kVarRest, kVarVisibility, kStepRest, kStepVisibility };

// The upper half of a float: the nearest number of three digits. It suffices for variances.
class HalfFloat {
 public:
  HalfFloat() = default;
  explicit HalfFloat(float v)
      : bits_(static_cast<std::uint16_t>((std::bit_cast<std::uint32_t>(v) + 0x8000) >> 16)) {}

 private:
  std::uint16_t bits_ = 0;
};

struct alignas(16) BakedVertex {
  float rest = 0, visibility = 0;
  HalfFloat var_rest = {}, var_visibility = {}, step_rest = {}, step_visibility = {};

  // By BakedLane; known fully.
  Octet light() const {
    const __m128i bits = _mm_load_si128(reinterpret_cast<const __m128i*>(this));
    const __m128i variances = _mm_unpackhi_epi16(__m128i{}, bits);
    const __m128 means = _mm_blend_ps(_mm_castsi128_ps(bits), _mm_set1_ps(1), 1 << kKnown | 1 << kUnused);
    return _mm256_set_m128(_mm_castsi128_ps(variances), means);
  }
};
static_assert(sizeof(BakedVertex) == 16);

}  // namespace saccade
