// Points of the sequence of net_digits.h in a random order, each coordinate scrambled as by Owen (1995). Both
// keep what makes nets of the points [Burley 2020, "Practical Hash-based Owen Scrambling"]. So points of
// different keys are independent, and can be put together to more dimensions.
#pragma once

#include "base/hash_rng.h"
#include "base/reverse_bits.h"
#include "render/sampling/net_digits.h"

namespace saccade {

// Flips each bit or not, as a hash of the key and of all lower bits says. Laine and Karras 2011, in the form
// of Vegdahl 2021.
template <class Bits>
[[gnu::always_inline]] constexpr Bits scrambleUpwards(Bits v, const Bits& key) {
  v ^= v * 0x3d20adeau;
  v += key;
  v *= (key >> 16) | 1u;
  v ^= v * 0x05526c56u;
  return v ^ (v * 0x53a22864u);
}

inline constexpr std::uint32_t kPointCoordinates = 3;

template <class Bits>
class ScrambledPoint {
 public:
  // The index comes with its bits reversed: numbers below 2^m have m bits at the top.
  [[gnu::always_inline]] ScrambledPoint(const Bits& reversed_index, const Bits& key)
      : index_(reverseBits(scrambleUpwards(reversed_index, key))), key_(key) {}

  // Fractions of 2^32.
  [[gnu::always_inline]] Bits at(std::uint32_t coordinate) const {
    const Bits digits = coordinate == 0   ? index_
                        : coordinate == 1 ? digitsInXPlus1(index_)
                                          : digitsInX2PlusXPlus1(index_);
    return reverseBits(scrambleUpwards<Bits>(digits, key_ * kKeys[coordinate]));
  }

 private:
  static constexpr std::uint32_t kKeys[] = {0x9e3779b1u, 0x85ebca77u, 0xc2b2ae3du};  // odd

  Bits index_, key_;
};

}  // namespace saccade
