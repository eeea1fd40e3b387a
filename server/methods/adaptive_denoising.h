// Denoises a pixel by regression, and keeps its parameters while they foretell no event. Tsuji et al. 2023,
// "Event-based camera simulation using Monte Carlo path tracing with adaptive denoising". RIVALS.md says what
// was chosen.
#pragma once

#include <vector>

#include "filter/local_regression.h"
#include "methods/method.h"

namespace saccade {

// adaptive_denoising.cpp states the range and the source of each parameter.
struct AdaptiveDenoisingParams {
  float threshold = 0.2f;
  float white = 1;
  int radius = 6;
  bool hold = false;
};

class AdaptiveDenoising final : public Method {
 public:
  AdaptiveDenoising(const AdaptiveDenoisingParams& params, int width, int height);
  static MethodInfo info();

  void start(const Frame& first, const PoolHandle& pool) override;
  void estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                StageTimes& times) override;

 private:
  // The parameters of a pixel at its last event.
  struct Kept {
    LocalModel model;
    RegressionFeatures features;  // of its centre
    std::array<float, 3> moved;   // from the place then to that of the frame before
  };
  Kept& keptAt(int x, int y) {
    return kept_[static_cast<std::size_t>(y) * static_cast<std::size_t>(I_prev_.width()) +
                 static_cast<std::size_t>(x)];
  }
  std::chrono::nanoseconds readBrightness(const Frame& frame, const PoolHandle& pool);
  // The brightness that a pixel shows. Refits it where an event may have come.
  float brightness(const FramePair& frames, int x, int y);

  AdaptiveDenoisingParams params_;
  std::vector<Kept> kept_;
  ImageF samples_;  // brightness of this frame's samples
  ImageF I_prev_;
};

}  // namespace saccade
