// How the rates of noise differ from pixel to pixel.
#pragma once

#include <cmath>
#include <cstdint>

#include "events/noise/noise_numbers.h"

namespace saccade {

// exp(s N(0, 1) - s^2 / 2), s = rate_spread: log-normal, with the mean 1. Leak and shot noise of a pixel have
// the same factor. [v2e: 10^(d N(0, 1)) with the median 1; s = 2.303 d]
inline double rateFactor(double rate_spread, std::uint64_t seed, std::uint32_t pixel) {
  if (rate_spread == 0) return 1;
  const std::uint64_t key = noiseKey(seed, NoiseNumbers::kRates);
  return std::exp(rate_spread * gaussian(hashKey(key, pixel)) - rate_spread * rate_spread / 2);
}

}  // namespace saccade
