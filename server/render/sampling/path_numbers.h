// The random numbers of W paths, those that PathSampler has for each.
#pragma once

#include "base/hash_rng.h"
#include "base/wide.h"

namespace saccade {

template <int W>
struct PathNumbers {
  Uints<W> key_low, key_high;

  // Uniform in [0, 1).
  [[gnu::always_inline]] Floats<W> u(std::uint32_t dimension) const {
    return unit(mix32(key_low ^ ofUpperKey(dimension)));
  }
  // The numbers that all paths with the same upper part of the key share.
  [[gnu::always_inline]] Uints<W> ofUpperKey(std::uint32_t dimension) const {
    return mix32(Uints<W>(key_high + dimension * 0x9e3779b9u));
  }
  // As toUnit().
  [[gnu::always_inline]] static Floats<W> unit(const Uints<W>& bits) {
    return toFloats(Uints<W>(bits >> 8)) * 0x1p-24f;
  }
};

}  // namespace saccade
