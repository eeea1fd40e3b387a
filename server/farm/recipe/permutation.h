// A random order of the numbers below a count, which needs no memory.
#pragma once

#include <bit>
#include <cstdint>

#include "base/hash_rng.h"

namespace saccade::farm {

// The place of `number` among the numbers below `count`: a bijection, different for each seed. A Feistel
// network over the next power of 4 is walked until it gives a number below `count` [Black and Rogaway 2002].
inline std::uint64_t shuffled(std::uint64_t number, std::uint64_t count, std::uint64_t seed) {
  const int half = (static_cast<int>(std::bit_width(count)) + 1) / 2;
  const std::uint64_t mask = (std::uint64_t{1} << half) - 1;
  do {
    std::uint64_t left = number >> half, right = number & mask;
    for (std::uint64_t round = 0; round < 4; ++round) {
      const std::uint64_t next = left ^ (hashKey(hashKey(seed, round), right) & mask);
      left = right, right = next;
    }
    number = left << half | right;
  } while (number >= count);
  return number;
}

}  // namespace saccade::farm
