// The random numbers of one path. Their address is (seed, pixel, sample, dimension), so that the same seed
// replays the path.
#pragma once

#include "base/hash_rng.h"

namespace saccade {

struct PathSampler {
  PathSampler() = default;
  PathSampler(std::uint64_t seed, std::uint32_t pixel, std::uint32_t sample)
      : PathSampler(hashKey(seed, (static_cast<std::uint64_t>(sample) << 32) | pixel)) {}
  PathSampler(std::uint32_t key_low, std::uint32_t key_high) : low(key_low), high(key_high) {}

  // Uniform in [0, 1).
  float u(std::uint32_t dimension) const {
    return toUnit(mix32(low ^ mix32(high + dimension * 0x9e3779b9u)));
  }

  std::uint32_t low = 0, high = 0;  // of its key

 private:
  explicit PathSampler(std::uint64_t key)
      : low(static_cast<std::uint32_t>(key)), high(static_cast<std::uint32_t>(key >> 32)) {}
};

}  // namespace saccade
