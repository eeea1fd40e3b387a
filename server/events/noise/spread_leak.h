// Leak whose rate differs from pixel to pixel.
#pragma once

#include <cstdint>
#include <vector>

#include "events/noise/noise_source.h"

namespace saccade {

// Pixel i has ON events at (n + u_i) / (leak_hz f_i), n = 0, 1, ..., with u_i uniform in [0, 1), and f_i its
// rateFactor(). The next event of all pixels is on top of a heap, so that time is taken per event.
class SpreadLeak final : public NoiseSource {
 public:
  SpreadLeak(const SensorConfig& config, int width, int height);

  void generate(const IntensityChange& change, NoiseSink& sink) override;

 private:
  struct Next {
    double t_ns;
    std::uint32_t pixel;
    friend bool operator>(const Next& a, const Next& b) {
      return a.t_ns != b.t_ns ? a.t_ns > b.t_ns : a.pixel > b.pixel;
    }
  };
  void start(double t0_ns);
  double phaseOf(std::uint32_t pixel) const;

  std::uint64_t key_;
  int width_;
  std::vector<float> periods_ns_;  // by pixel
  std::vector<Next> heap_;         // the earliest first; empty before the first interval
};

}  // namespace saccade
