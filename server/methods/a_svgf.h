// A-SVGF: SVGF whose history is forgotten where light has changed. Schied, Peters and Dachsbacher 2018,
// "Gradient estimation for real-time adaptive temporal filtering". RIVALS.md says what was chosen.
#pragma once

#include "filter/temporal_gradient.h"
#include "methods/method.h"
#include "methods/svgf.h"

namespace saccade {

// a_svgf.cpp and svgf_common.h state the range and the source of each parameter.
struct ASvgfParams : SvgfCommonParams {
  int gradient_iterations = 3;
};

class ASvgf final : public Method {
 public:
  ASvgf(const ASvgfParams& params, int width, int height)
      : gradient_(width, height, params.gradient_iterations),
        svgf_(SvgfParams{params, false}, width, height, &gradient_) {}
  static MethodInfo info();

  void start(const Frame& first, const PoolHandle& pool) override { svgf_.start(first, pool); }
  void estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                StageTimes& times) override;

 private:
  TemporalGradient gradient_;
  Svgf svgf_;
};

}  // namespace saccade
