// Samples each pixel until a test decides its event. Manabe et al. 2024, "Monte Carlo path tracing and
// statistical event detection for event camera simulation". RIVALS.md says what was chosen.
#pragma once

#include "methods/event_test.h"
#include "methods/round_method.h"

namespace saccade {

// adaptive_sampling.cpp states the range and the source of each parameter.
struct AdaptiveSamplingParams {
  float threshold = 0.2f;
  float bias = 1e-3f;
  bool hold = false;
  bool independent_numbers = false;
};

class AdaptiveSampling final : public RoundMethod {
 public:
  AdaptiveSampling(const AdaptiveSamplingParams& params, int width, int height);
  static MethodInfo info();

  int nextRound(int spp, const PoolHandle& pool) override;
  const Image<int>& wanted() const override { return wanted_; }
  void take(Frame& frame, const PoolHandle& pool) override;
  void start(const Frame& first, const PoolHandle& pool) override;
  void estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                StageTimes& times) override;

 private:
  BrightnessMean brightness(int x, int y) const;
  // Whether the pixel needs another round.
  bool undecided(int x, int y) const;
  // Makes the light of this frame that of the last event, where one has come.
  void keepEvents(bool all, const PoolHandle& pool);

  AdaptiveSamplingParams params_;
  bool first_ = true;  // the frame has no last event
  int round_ = 0;      // of the frame
  Image<int> wanted_;
  // Of this frame, over its rounds: of light, of log brightness and of its square.
  ImageF sum_, log_sum_, log_squares_;
  Image<int> rounds_;                          // of each pixel
  ImageF last_mean_, last_var_, last_rounds_;  // log brightness at the last event
  ImageF held_;                                // light at the last event
  ImageF I_prev_, var_I_prev_;
};

}  // namespace saccade
