// SVGF, which EventSVGF is compared with: it filters each frame by itself, then takes the difference,
// D[I_t] - D[I_{t-1}] [E (7)].
#pragma once

#include "filter/filter_planes.h"
#include "filter/temporal_accumulation.h"
#include "methods/method.h"
#include "methods/svgf_common.h"

namespace saccade {

// svgf.cpp and svgf_common.h state the range and the source of each parameter.
struct SvgfParams : SvgfCommonParams {
  bool as_falcor = false;
};

class Svgf final : public Method {
 public:
  // `gradient`: raises the weights of new samples where it tells of a change; nullptr: nothing does.
  Svgf(const SvgfParams& params, int width, int height, const TemporalGradient* gradient = nullptr);
  static MethodInfo info();

  void start(const Frame& first, const PoolHandle& pool) override;
  void estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                StageTimes& times) override;

  // The same, where the illumination of the pixels with SurfaceSamples is known better than by their samples;
  // nullptr: it is not.
  void start(const Frame& first, const ImageF* known, const PoolHandle& pool);
  void estimate(const FramePair& frames, const ImageF* known, const PoolHandle& pool, IntensityChange& out,
                StageTimes& times);

 private:
  // Accumulates and filters into filtered_.
  void filter(const FramePair& frames, const ImageF* known, const PoolHandle& pool, StageTimes& times);
  // I = A D[i] + E, and its variance.
  std::chrono::nanoseconds remodulate(const Frame& frame, const PoolHandle& pool, ImageF& I,
                                      ImageF& variance) const;

  SvgfParams params_;
  AccumulationParams accumulation_;
  VarianceParams variance_;
  AtrousParams atrous_;
  IlluminationSamples samples_;
  History history_, history_prev_;
  FilterPlanes filtered_, scratch_;
  ImageF I_prev_, var_I_prev_;  // D[I_{t-1}] and its variance
};

}  // namespace saccade
