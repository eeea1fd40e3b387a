// A random choice of pixels: hot ones, dead ones.
#pragma once

#include <cstdint>
#include <vector>

#include "events/noise/noise_numbers.h"

namespace saccade {

// Whether a pixel is one of the chosen, each independently with the probability `fraction`.
inline bool isChosen(std::uint64_t key, std::uint32_t pixel, double fraction) {
  return uniform(hashKey(key, pixel)) < fraction;
}

// The indices of the chosen of `count` pixels.
inline std::vector<std::uint32_t> choosePixels(std::uint64_t key, std::uint32_t count, double fraction) {
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t pixel = 0; pixel < count; ++pixel) {
    if (isChosen(key, pixel, fraction)) chosen.push_back(pixel);
  }
  return chosen;
}

}  // namespace saccade
