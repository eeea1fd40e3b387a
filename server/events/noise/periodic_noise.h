// ON events that some pixels make periodically, each at a phase of its own: leak, and hot pixels.
#pragma once

#include <cstdint>
#include <vector>

#include "events/noise/noise_source.h"

namespace saccade {

// Pixel i has events at (n + u_i) / rate, n = 0, 1, ..., u_i uniform in [0, 1).
class PeriodicNoise final : public NoiseSource {
 public:
  // `pixels`: indices y * width + x. rate > 0.
  PeriodicNoise(const std::vector<std::uint32_t>& pixels, double rate_hz, std::uint64_t key, int width);

  void generate(const IntensityChange& change, NoiseSink& sink) override;

 private:
  // ns, of the event of this entry in a cycle of all pixels.
  double timeOf(double cycle, std::uint64_t entry) const;

  // The calendar of a cycle: phase in 2^-32, then the pixel in the lower half; in order.
  std::vector<std::uint64_t> calendar_;
  double period_ns_;
  int width_;
};

}  // namespace saccade
