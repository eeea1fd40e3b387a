// Vectors of floats that one vertex or cell keeps.
#pragma once

#include <immintrin.h>

#include <array>
#include <cstdint>

namespace saccade {

using Indices = std::uint32_t __attribute__((vector_size(16)));  // of vertices
using Quad = float __attribute__((vector_size(16)));
using Octet = float __attribute__((vector_size(32)));

// Eight octets, each a row of a square: its columns.
inline std::array<Octet, 8> transposed(const std::array<Octet, 8>& rows) {
  std::array<Octet, 8> pairs, quads, columns;
  for (int i = 0; i < 8; i += 2) {
    pairs[i] = _mm256_unpacklo_ps(rows[i], rows[i + 1]);
    pairs[i + 1] = _mm256_unpackhi_ps(rows[i], rows[i + 1]);
  }
  constexpr int kLow = 0x44, kHigh = 0xee;  // the lower, or the upper, pairs of both
  for (int i = 0; i < 8; i += 4) {
    quads[i] = _mm256_shuffle_ps(pairs[i], pairs[i + 2], kLow);
    quads[i + 1] = _mm256_shuffle_ps(pairs[i], pairs[i + 2], kHigh);
    quads[i + 2] = _mm256_shuffle_ps(pairs[i + 1], pairs[i + 3], kLow);
    quads[i + 3] = _mm256_shuffle_ps(pairs[i + 1], pairs[i + 3], kHigh);
  }
  for (int i = 0; i < 4; ++i) {
    columns[i] = _mm256_permute2f128_ps(quads[i], quads[i + 4], 0x20);
    columns[i + 4] = _mm256_permute2f128_ps(quads[i], quads[i + 4], 0x31);
  }
  return columns;
}

}  // namespace saccade
