// The random numbers of W paths, those that PathSampler has for each.
#pragma once

#include "render/sampling/path_sampler.h"

namespace saccade {

template <int W>
struct PathNumbers {
  Uints<W> reversed_index, key;

  // Those of a group of dimensions, of which this is the first.
  [[gnu::always_inline]] ScrambledPoint<Uints<W>> point(std::uint32_t dimension) const {
    return {reversed_index, groupKey(key, dimension / PathSampler::kGroup)};
  }
  // As toUnit().
  [[gnu::always_inline]] static Floats<W> unit(const Uints<W>& bits) {
    return toFloats(Uints<W>(bits >> 8)) * 0x1p-24f;
  }
};

}  // namespace saccade
