// Shot noise: ON and OFF events at random times, more of them in the dark.
#pragma once

#include <cstdint>

#include "events/noise/noise_source.h"

namespace saccade {

// The events of a pixel are a Poisson process of the rate
//
//   r(I) = shot_hz (1 - 3/4 min(I, R) / R), R the reference luminance; half of them are ON  [v2e]
//
// One process of the rate pixels * shot_hz proposes events at uniform pixels. An event at a pixel of
// intensity I is taken with the probability r(I) / shot_hz. This is the same process for each pixel, at a
// cost per event.
class ShotNoise final : public NoiseSource {
 public:
  ShotNoise(const NoiseConfig& noise, std::uint64_t key, int width, int height);

  void generate(const IntensityChange& change, NoiseSink& sink) override;

 private:
  double shareOf(float I) const;  // r(I) / shot_hz

  std::uint64_t key_;
  int width_;
  std::uint64_t pixels_;
  double mean_gap_ns_, reference_;
};

}  // namespace saccade
