// The accumulation and the spatial filter of NVIDIA RELAX, in the difference-aware form of EventSVGF: what
// the paper's last section names as future work. RIVALS.md says what was taken over.
#pragma once

#include "filter/atrous.h"
#include "filter/fast_history.h"
#include "filter/temporal_accumulation.h"
#include "filter/variance.h"
#include "methods/method.h"

namespace saccade {

// relax.cpp states the range and the source of each parameter.
struct RelaxParams {
  int max_history = 30;
  int fast_history = 6;
  float clamp = 2;
  bool anti_firefly = true;
  int iterations = 5;
  float sigma_l = 2;
  float sigma_l_diff = 2;
  float sigma_n = 128;
  float sigma_z = 1;
  bool independent_numbers = false;
};

class Relax final : public Method {
 public:
  Relax(const RelaxParams& params, int width, int height);
  static MethodInfo info();

  void start(const Frame& first, const PoolHandle& pool) override;
  void estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                StageTimes& times) override;

 private:
  void accumulateFrame(const FramePair& frames, const PoolHandle& pool, StageTimes& times);
  // Filters over space into filtered_.
  void filter(const FramePair& frames, const PoolHandle& pool, StageTimes& times);

  RelaxParams params_;
  AccumulationParams accumulation_;
  VarianceParams variance_;
  AtrousParams atrous_;
  IlluminationSamples samples_;
  History history_, history_prev_;
  FastHistory fast_, fast_prev_;
  ImageF I_prev2_, fast_I_prev2_;  // I' of two frames ago, of both histories
  FilterPlanes filtered_, scratch_;
  ImageF i_prev_, var_i_prev_;  // D[i_{t-1}] and its variance
};

}  // namespace saccade
