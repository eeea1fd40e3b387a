// Lanes: W values that one instruction works on. W is 8 with AVX2 and 16 with AVX-512.
//
// std::experimental::simd gives operators, masks and functions on lanes, and comes with the compiler. This
// adds what it lacks: selecting, gathering and compressing.
#pragma once

#include <immintrin.h>

#include <array>
#include <bit>
#include <cstdint>
#include <experimental/simd>

#include "base/lane_set.h"

namespace saccade {

namespace stdx = std::experimental;

template <int W>
using Floats = stdx::simd<float, stdx::simd_abi::deduce_t<float, W>>;
template <int W>
using Ints = stdx::rebind_simd_t<std::int32_t, Floats<W>>;
template <int W>
using Uints = stdx::rebind_simd_t<std::uint32_t, Floats<W>>;
template <int W>
using Mask = typename Floats<W>::mask_type;

// a where the condition holds, otherwise b.
inline float select(bool condition, float a, float b) {
  return condition ? a : b;
}
template <class T, class Abi>
[[gnu::always_inline]] inline stdx::simd<T, Abi> select(const stdx::simd_mask<T, Abi>& condition,
                                                        const std::type_identity_t<stdx::simd<T, Abi>>& a,
                                                        std::type_identity_t<stdx::simd<T, Abi>> b) {
#ifdef __AVX512F__
  // Clang 14 takes the operands of where() in the wrong order here, with the library of GCC 12.
  if constexpr (sizeof(condition) == sizeof(__mmask16)) {
    const auto bits = std::bit_cast<__mmask16>(condition);
    const __m512 chosen = _mm512_mask_blend_ps(bits, std::bit_cast<__m512>(b), std::bit_cast<__m512>(a));
    return std::bit_cast<stdx::simd<T, Abi>>(chosen);
  }
#endif
  where(condition, b) = a;
  return b;
}

// Of whole numbers below 2^31.
template <class Abi>
[[gnu::always_inline]] inline auto toUints(const stdx::simd<float, Abi>& v) {
  using I = stdx::rebind_simd_t<std::int32_t, stdx::simd<float, Abi>>;
  using U = stdx::rebind_simd_t<std::uint32_t, stdx::simd<float, Abi>>;
  return stdx::static_simd_cast<U>(stdx::static_simd_cast<I>(v));
}
template <class Abi>
[[gnu::always_inline]] inline auto toFloats(const stdx::simd<std::uint32_t, Abi>& v) {
  using I = stdx::rebind_simd_t<std::int32_t, stdx::simd<std::uint32_t, Abi>>;
  using F = stdx::rebind_simd_t<float, stdx::simd<std::uint32_t, Abi>>;
  return stdx::static_simd_cast<F>(stdx::static_simd_cast<I>(v));
}

// From and to memory that starts on 64 bytes, at a multiple of W.
template <int W>
[[gnu::always_inline]] inline Floats<W> load(const float* p) {
  return Floats<W>(p, stdx::vector_aligned);
}
template <int W>
[[gnu::always_inline]] inline Uints<W> load(const std::uint32_t* p) {
  return Uints<W>(p, stdx::vector_aligned);
}
template <class T, class Abi>
[[gnu::always_inline]] inline void store(const stdx::simd<T, Abi>& v, T* p) {
  v.copy_to(p, stdx::vector_aligned);
}

// The lanes of a mask.
template <class Abi>
[[gnu::always_inline]] inline LaneSet lanesOf(const stdx::simd_mask<float, Abi>& mask) {
  if constexpr (sizeof(mask) == sizeof(std::uint16_t)) {
    return {std::bit_cast<std::uint16_t>(mask)};
  } else {
    const auto sign = select(mask, -1.f, 0.f);
    return {static_cast<std::uint32_t>(_mm256_movemask_ps(static_cast<__m256>(sign)))};
  }
}

// 0, 1, ... W - 1.
template <int W>
[[gnu::always_inline]] inline Uints<W> laneNumbers() {
  return Uints<W>([](auto lane) { return static_cast<std::uint32_t>(lane); });
}
// The mask of a set.
template <int W>
[[gnu::always_inline]] inline Mask<W> maskOf(LaneSet lanes) {
  const Uints<W> lane = Uints<W>(lanes.bits) >> laneNumbers<W>();
  return toFloats(Uints<W>(lane & 1u)) > 0.f;
}
// The lanes below `count`.
template <int W>
[[gnu::always_inline]] inline Mask<W> firstLanes(int count) {
  return Floats<W>([](auto lane) { return static_cast<float>(lane); }) < static_cast<float>(count);
}

// p[index] of each lane.
[[gnu::always_inline]] inline Floats<8> gather(const float* p, const Uints<8>& index) {
  return Floats<8>(_mm256_i32gather_ps(p, static_cast<__m256i>(index), 4));
}
#ifdef __AVX512F__
[[gnu::always_inline]] inline Floats<16> gather(const float* p, const Uints<16>& index) {
  return Floats<16>(_mm512_i32gather_ps(static_cast<__m512i>(index), p, 4));
}
#endif
template <class Abi>
[[gnu::always_inline]] inline auto gather(const std::uint32_t* p,
                                          const stdx::simd<std::uint32_t, Abi>& index) {
  return std::bit_cast<stdx::simd<std::uint32_t, Abi>>(gather(reinterpret_cast<const float*>(p), index));
}

// For each mask of eight lanes, the numbers of the lanes that are set, a byte each.
inline constexpr auto kSetLanes = [] {
  std::array<std::uint64_t, 256> table{};
  for (unsigned lanes = 0; lanes < 256; ++lanes)
    for (unsigned lane = 0, set = 0; lane < 8; ++lane)
      if (lanes >> lane & 1) table[lanes] |= std::uint64_t(lane) << (8 * set++);
  return table;
}();

// Writes the lanes of a set one after another. The values that follow them in out[0, W) are overwritten too.
[[gnu::always_inline]] inline void compress(LaneSet lanes, const Floats<8>& v, float* out) {
  const __m256i index =
      _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(kSetLanes[lanes.bits])));
  _mm256_storeu_ps(out, _mm256_permutevar8x32_ps(static_cast<__m256>(v), index));
}
#ifdef __AVX512F__
[[gnu::always_inline]] inline void compress(LaneSet lanes, const Floats<16>& v, float* out) {
  _mm512_storeu_ps(out, _mm512_maskz_compress_ps(static_cast<__mmask16>(lanes.bits), static_cast<__m512>(v)));
}
#endif
template <class Abi>
[[gnu::always_inline]] inline void compress(LaneSet lanes, const stdx::simd<std::uint32_t, Abi>& v,
                                            std::uint32_t* out) {
  using F = stdx::rebind_simd_t<float, stdx::simd<std::uint32_t, Abi>>;
  compress(lanes, std::bit_cast<F>(v), reinterpret_cast<float*>(out));
}

}  // namespace saccade
