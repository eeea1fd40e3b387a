// The parameters and the spatial filter that SVGF and EventSVGF share.
#pragma once

#include "filter/atrous.h"
#include "filter/filter_planes.h"
#include "filter/variance.h"
#include "methods/filter_fields.h"

namespace saccade {

// The defaults are Falcor's, with the paper's alpha.
struct SvgfCommonParams {
  float alpha = 0.1f;
  float moments_alpha = 0.2f;
  int max_history = 32;
  int iterations = 4;
  int feedback_tap = 1;
  float sigma_l = 10;
  float sigma_n = 128;
  float sigma_z = 1;
  bool independent_numbers = false;

  // The variance of a running mean of weight alpha, as a share of the variance of one frame's sample, which
  // the filter works with.
  float varianceScale() const { return alpha / (2 - alpha); }
};

// The rows of these parameters for a method whose parameters P derive from them, followed by `more`.
template <class P>
std::vector<ParamField<P>> withCommonFields(const std::vector<ParamField<P>>& more) {
  std::vector<ParamField<P>> fields = withFilterFields<P>(
      "Falcor", {{"alpha", &P::alpha, 0.001, 1, "least weight of the new sample; 1: no history",
                  "paper 5.1 (Falcor: 0.05)"},
                 {"moments_alpha", &P::moments_alpha, 0.001, 1,
                  "least weight of the new sample in the moments", "Falcor"},
                 {"feedback_tap", &P::feedback_tap, -1, 4,
                  "iteration whose result becomes the history; -1: none", "Falcor"}});
  fields.insert(fields.end(), more.begin(), more.end());
  return fields;
}

// Estimates the variance, then runs the a-trous iterations, each twice as wide. The result of the iteration
// at the feedback tap becomes the history. Leaves the result in `filtered`.
void filterOverSpace(const FramePair& frames, const SvgfCommonParams& params, const VarianceParams& variance,
                     const AtrousParams& atrous, const PoolHandle& pool, History& history,
                     FilterPlanes& filtered, FilterPlanes& scratch, StageTimes& times);

}  // namespace saccade
