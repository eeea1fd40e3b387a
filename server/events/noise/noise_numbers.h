// The random numbers of noise, by address.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "base/hash_rng.h"

namespace saccade {

// Each use has numbers of its own.
enum class NoiseNumbers : std::uint64_t {
  kThresholdOn = 1,
  kThresholdOff,
  kLeakPhase,
  kShot,
  kHotPixels,
  kHotPhase,
  kDeadPixels,
  kJitter,
  kRates
};

inline std::uint64_t noiseKey(std::uint64_t seed, NoiseNumbers use) {
  constexpr std::uint64_t kNoise = 0x6e6f697365;  // apart from the numbers of the event models
  return hashKey(hashKey(seed, kNoise), static_cast<std::uint64_t>(use));
}

// Uniform in (0, 1).
inline double uniform(std::uint64_t bits) {
  return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
}

// Standard normal [Box and Muller 1958].
inline double gaussian(std::uint64_t key) {
  const double radius = std::sqrt(-2 * std::log(uniform(hashKey(key, 0))));
  return radius * std::cos(2 * std::numbers::pi * uniform(hashKey(key, 1)));
}

}  // namespace saccade
