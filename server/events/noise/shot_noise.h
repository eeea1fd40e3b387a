// Shot noise: ON and OFF events at random times, more of them in the dark.
#pragma once

#include <cstdint>
#include <vector>

#include "events/noise/noise_source.h"

namespace saccade {

// The events of a pixel are a Poisson process of the rate
//
//   r(I) = shot_hz (1 - 3/4 min(I, R) / R), R the reference luminance; half of them are ON  [v2e]
//
// times the pixel's rateFactor(). I includes the dark current. One process of the sum of the pixels' rates in
// the dark proposes events, at pixels in proportion to their factor. An event at a pixel of intensity I is
// taken with the probability r(I) / shot_hz. This is the same process for each pixel, at a cost per event.
class ShotNoise final : public NoiseSource {
 public:
  ShotNoise(const SensorConfig& config, int width, int height);

  void generate(const IntensityChange& change, NoiseSink& sink) override;

 private:
  double shareOf(float I) const;  // r(I) / shot_hz
  std::uint32_t pixelOf(std::uint64_t number) const;

  std::uint64_t key_;
  int width_;
  std::uint64_t pixels_;
  std::vector<double> factors_;  // summed up to each pixel; empty where all are 1
  double mean_gap_ns_, reference_, dark_;
};

}  // namespace saccade
