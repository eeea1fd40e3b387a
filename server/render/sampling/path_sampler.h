// The random numbers of one path. Equal addresses give equal numbers, so that a seed replays the path: a key,
// an index and a dimension.
//
// Dimensions come in groups. The paths of one key have points of one sequence in each group, every group in
// an order of its own. A path whose index is a hash has independent numbers.
#pragma once

#include "render/sampling/scrambled_point.h"

namespace saccade {

inline constexpr std::uint32_t kGroupStep = 0x9e3779b9u;

template <class Bits>
[[gnu::always_inline]] constexpr Bits groupKey(const Bits& key, std::uint32_t group) {
  return mix32(Bits(key + group * kGroupStep));
}

struct PathSampler {
  static constexpr std::uint32_t kGroup = kPointCoordinates;  // dimensions

  PathSampler() = default;
  PathSampler(std::uint32_t reversed_index, std::uint32_t key) : reversed_index(reversed_index), key(key) {}
  // Independent numbers.
  PathSampler(std::uint64_t seed, std::uint32_t pixel, std::uint32_t sample)
      : PathSampler(hashKey(seed, (static_cast<std::uint64_t>(sample) << 32) | pixel)) {}

  // Uniform in [0, 1).
  float u(std::uint32_t dimension) const {
    return toUnit(ScrambledPoint(reversed_index, groupKey(key, dimension / kGroup)).at(dimension % kGroup));
  }

  // The numbers from the first dimension of a group on.
  PathSampler from(std::uint32_t dimension) const {
    return {reversed_index, key + dimension / kGroup * kGroupStep};
  }

  std::uint32_t reversed_index = 0;  // 32 bits, in reverse order
  std::uint32_t key = 0;

 private:
  explicit PathSampler(std::uint64_t both)
      : PathSampler(static_cast<std::uint32_t>(both), static_cast<std::uint32_t>(both >> 32)) {}
};

}  // namespace saccade
