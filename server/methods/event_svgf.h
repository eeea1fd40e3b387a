// EventSVGF: the temporal difference itself, accumulated and filtered (paper, 4.3 - 4.5, Figure 4).
#pragma once

#include "filter/filter_planes.h"
#include "filter/temporal_accumulation.h"
#include "methods/method.h"
#include "methods/svgf_common.h"

namespace saccade {

// event_svgf.cpp and svgf_common.h state the range and the source of each parameter.
struct EventSvgfParams : SvgfCommonParams {
  float sigma_l_diff = 10;
  // Ablations of Figure 9, and of the correction term.
  bool correlated = true;
  bool w_prev = true;
  bool accumulate_difference = true;
  bool demodulate = true;
  bool correction = true;
  bool motion_aligned = false;  // appendix C
};

class EventSvgf final : public Method {
 public:
  EventSvgf(const EventSvgfParams& params, int width, int height);
  static MethodInfo info();

  void start(const Frame& first, const PoolHandle& pool) override;
  void estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                StageTimes& times) override;

 private:
  // Accumulates and filters into filtered_.
  void filter(const FramePair& frames, const PoolHandle& pool, StageTimes& times);

  EventSvgfParams params_;
  AccumulationParams accumulation_;
  VarianceParams variance_;
  AtrousParams atrous_;
  IlluminationSamples samples_;
  History history_, history_prev_;  // of this frame and the one before
  ImageF I_prev2_;                  // I' of two frames ago
  FilterPlanes filtered_, scratch_;
  ImageF i_prev_, var_i_prev_;  // D[i_{t-1}] and its variance
};

}  // namespace saccade
