// A low-discrepancy sequence in three dimensions, of numbers or of lanes of them.
//
// Read the index of a point as a polynomial over the two-element field: bit k is the coefficient of x^k. The
// coordinates are its digits in the bases x, x + 1 and x^2 + x + 1, the lowest digit behind the binary point
// (Niederreiter 1988). The first two are those of Sobol (1967). Take any 2^m points from a multiple of 2^m
// on. They are a (0, m, 2)-net in the first two coordinates, and a (1, m, 3)-net in all three.
//
// Squares are simple in this field. Where L is a power of two, (x + 1)^L = x^L + 1, and
// (x^2 + x + 1)^L = x^(2 L) + x^L + 1. So a division by such a power takes a few shifts, and halves of halves
// give all digits.
#pragma once

#include <cstdint>

namespace saccade {

// The quotient of h x^L + l by (x + 1)^L is h, and the remainder h + l.
template <class Bits>
[[gnu::always_inline]] constexpr Bits digitsInXPlus1(Bits n) {
  n ^= n >> 16;
  n ^= (n >> 8) & 0x00ff00ffu;
  n ^= (n >> 4) & 0x0f0f0f0fu;
  n ^= (n >> 2) & 0x33333333u;
  return n ^ ((n >> 1) & 0x55555555u);
}

// With quarters a, b, c, d the quotient is (a, a + b) and the remainder (b + c, a + b + d). A digit has two
// bits.
template <class Bits>
[[gnu::always_inline]] constexpr Bits digitsInX2PlusXPlus1(Bits n) {
  n ^= (n >> 8) & 0x00ffff00u, n ^= (n >> 16) & 0x000000ffu;
  n ^= (n >> 4) & 0x0ff00ff0u, n ^= (n >> 8) & 0x000f000fu;
  n ^= (n >> 2) & 0x3c3c3c3cu, n ^= (n >> 4) & 0x03030303u;
  n ^= (n >> 1) & 0x66666666u;
  return n ^ ((n >> 2) & 0x11111111u);
}

}  // namespace saccade
