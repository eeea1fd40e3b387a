// The random numbers of W paths, those that PathSampler has for each.
#pragma once

#include "render/sampling/path_sampler.h"

namespace saccade {

template <int W>
struct PathNumbers {
  Uints<W> reversed_index, key;

  // The numbers of a group of dimensions: `dimension` is the first of the group.
  [[gnu::always_inline]] ScrambledPoint<Uints<W>> point(std::uint32_t dimension) const {
    return {reversed_index, groupKey(key, dimension / PathSampler::kGroup)};
  }
  // As toUnit().
  [[gnu::always_inline]] static Floats<W> unit(const Uints<W>& bits) {
    return toFloats(Uints<W>(bits >> 8)) * 0x1p-24f;
  }
};

}  // namespace saccade
