// The random numbers of one path. Their address is (seed, pixel, sample, dimension), so that the same seed
// replays the path.
#pragma once

#include "base/hash_rng.h"

namespace saccade {

class PathSampler {
 public:
  PathSampler(std::uint64_t seed, std::uint32_t pixel, std::uint32_t sample)
      : key_(hashKey(seed, (static_cast<std::uint64_t>(sample) << 32) | pixel)) {}

  // Uniform in [0, 1).
  float u(std::uint32_t dimension) const {
    const auto low = static_cast<std::uint32_t>(key_), high = static_cast<std::uint32_t>(key_ >> 32);
    return toUnit(mix32(low ^ mix32(high + dimension * 0x9e3779b9u)));
  }

 private:
  std::uint64_t key_;
};

}  // namespace saccade
