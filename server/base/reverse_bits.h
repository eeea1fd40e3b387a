// Numbers with their 32 bits in reverse order, one by one or in lanes.
#pragma once

#include "base/wide.h"

namespace saccade {

constexpr std::uint32_t reverseBits(std::uint32_t v) {
  v = v >> 16 | v << 16;
  v = (v >> 8 & 0x00ff00ffu) | (v & 0x00ff00ffu) << 8;
  v = (v >> 4 & 0x0f0f0f0fu) | (v & 0x0f0f0f0fu) << 4;
  v = (v >> 2 & 0x33333333u) | (v & 0x33333333u) << 2;
  return (v >> 1 & 0x55555555u) | (v & 0x55555555u) << 1;
}

// Tables reverse both halves of each byte, and a shuffle the bytes.
[[gnu::always_inline]] inline Uints<8> reverseBits(const Uints<8>& v) {
  const auto every = [](std::uint64_t high, std::uint64_t low) {
    const auto signed_high = static_cast<long long>(high), signed_low = static_cast<long long>(low);
    return _mm256_set_epi64x(signed_high, signed_low, signed_high, signed_low);
  };
  const __m256i of_low = every(0xf070b030d0509010, 0xe060a020c0408000),
                of_high = every(0x0f070b030d050901, 0x0e060a020c040800),
                bytes = every(0x0c0d0e0f08090a0b, 0x0405060700010203), low_half = _mm256_set1_epi8(0x0f);
  const auto bits = static_cast<__m256i>(v);
  const __m256i low = _mm256_and_si256(bits, low_half),
                high = _mm256_and_si256(_mm256_srli_epi16(bits, 4), low_half);
  const __m256i reversed =
      _mm256_or_si256(_mm256_shuffle_epi8(of_low, low), _mm256_shuffle_epi8(of_high, high));
  return Uints<8>(_mm256_shuffle_epi8(reversed, bytes));
}
#ifdef __AVX512F__
[[gnu::always_inline]] inline Uints<16> reverseBits(const Uints<16>& v) {
  const auto every = [](std::uint64_t high, std::uint64_t low) {
    const auto signed_high = static_cast<long long>(high), signed_low = static_cast<long long>(low);
    return _mm512_set_epi64(signed_high, signed_low, signed_high, signed_low, signed_high, signed_low,
                            signed_high, signed_low);
  };
  const __m512i of_low = every(0xf070b030d0509010, 0xe060a020c0408000),
                of_high = every(0x0f070b030d050901, 0x0e060a020c040800),
                bytes = every(0x0c0d0e0f08090a0b, 0x0405060700010203), low_half = _mm512_set1_epi8(0x0f);
  const auto bits = static_cast<__m512i>(v);
  const __m512i low = _mm512_and_si512(bits, low_half),
                high = _mm512_and_si512(_mm512_srli_epi16(bits, 4), low_half);
  const __m512i reversed =
      _mm512_or_si512(_mm512_shuffle_epi8(of_low, low), _mm512_shuffle_epi8(of_high, high));
  return Uints<16>(_mm512_shuffle_epi8(reversed, bytes));
}
#endif

}  // namespace saccade
