// The numbers of a point's shadow rays: the R3 sequence (Roberts 2018). Its start is spread evenly over
// neighbours, and is the same in all frames.
#pragma once

#include <cstdint>

#include "base/hash_rng.h"

namespace saccade {

class RayNumbers {
 public:
  RayNumbers(int column, int y)
      : column_(static_cast<std::uint32_t>(column)), row_(static_cast<std::uint32_t>(y)) {}
  // In [0, 1). `dimension`: 0 to 2.
  float u(int ray, int dimension) const {
    return toUnit(static_cast<std::uint32_t>(ray) * kOfRay[dimension] + column_ * kOfColumn[dimension] +
                  row_ * kOfRow[dimension]);
  }

 private:
  // As fractions of 2^32. Those of columns and rows are R2, and fractions of square roots of primes.
  static constexpr std::uint32_t kOfRay[] = {0xd1b54a33u, 0xabc98389u, 0x8cb92ba7u};
  static constexpr std::uint32_t kOfColumn[] = {0xc13fa9a9u, 0x6a09e667u, 0xbb67ae85u};
  static constexpr std::uint32_t kOfRow[] = {0x91e10da5u, 0x9b05688cu, 0x1f83d9abu};

  std::uint32_t column_, row_;
};

}  // namespace saccade
