#include "methods/relax.h"

#include <cmath>
#include <utility>

#include "filter/anti_firefly.h"
#include "filter/demodulation.h"
#include "methods/filter_fields.h"

namespace saccade {
namespace {

using P = RelaxParams;

const std::vector<ParamField<P>>& fields() {
  static const std::vector<ParamField<P>> table = withFilterFields<P>(
      "RELAX",
      {{"sigma_l_diff", &P::sigma_l_diff, 0.01, 1000, "luminance tolerance of the difference",
        "RELAX, as sigma_l"},
       {"fast_history", &P::fast_history, 1, 1024, "frames of the history that clamps the other", "RELAX"},
       {"clamp", &P::clamp, 0, 1000,
        "standard deviations of the fast history that the slow one may be from its mean", "RELAX"},
       {"anti_firefly", &P::anti_firefly, 0, 1,
        "1: a pixel beyond all its neighbours takes the value of the nearest", "RELAX"}});
  return table;
}

// Of seven planes more than other methods have, with borders. A picture is at most 16 times as wide as high.
double relaxBytes(const ParamValues&, const ViewTraits& view) {
  constexpr double kPlanes = 7, kLongest = 4.25;  // both sides together, over the root of their product
  constexpr double kBorders = 2 * ImageF::kBorder;
  return kPlanes * sizeof(float) * (view.pixels + kBorders * (kLongest * std::sqrt(view.pixels) + kBorders));
}

}  // namespace

MethodInfo Relax::info() {
  MethodInfo info{
      "relax", "RELAX on the difference: a fast history clamps a slow one, no fireflies, a small kernel",
      paramSpecs(fields()),
      [](const ParamValues& values) -> SeedPlanner {
        return seedsWith<SeedPlan::correlated>(makeParams(fields(), values).independent_numbers);
      },
      [](const MethodSetup& setup) -> std::unique_ptr<Method> {
        return std::make_unique<Relax>(makeParams(fields(), setup.params), setup.width, setup.height);
      }};
  info.memory = relaxBytes;
  return info;
}

Relax::Relax(const RelaxParams& p, int w, int h)
    : params_(p),
      accumulation_{.alpha = 0, .moments_alpha = 0, .max_history = static_cast<float>(p.max_history)},
      variance_{.sigma_l = 10, .sigma_n = p.sigma_n},
      atrous_{.sigma_z = p.sigma_z,
              .sigma_n = p.sigma_n,
              .sigma_l = p.sigma_l,
              .sigma_l_diff = p.sigma_l_diff,
              .kernel = AtrousKernel::k3x3},
      samples_(w, h),
      history_(w, h),
      history_prev_(w, h),
      fast_(w, h),
      fast_prev_(w, h),
      I_prev2_(w, h),
      fast_I_prev2_(w, h),
      filtered_(w, h),
      scratch_(w, h),
      i_prev_(w, h),
      var_i_prev_(w, h) {}

void Relax::start(const Frame& first, const PoolHandle& pool) {
  StageTimes unused;
  const FramePair frames = FramePair::first(first);
  accumulateFrame(frames, pool, unused);
  filter(frames, pool, unused);
}

void Relax::estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                     StageTimes& times) {
  std::swap(i_prev_, filtered_.i);
  std::swap(var_i_prev_, filtered_.var_i);
  accumulateFrame(frames, pool, times);
  filter(frames, pool, times);
  // The variance of a mean of so many frames, as a share of that of one.
  const float variance_scale = 1 / static_cast<float>(params_.max_history);
  times[Stage::kModulate] +=
      modulate(frames, Demodulation::kAlbedo, variance_scale, filtered_, i_prev_, var_i_prev_, pool, out);
}

void Relax::accumulateFrame(const FramePair& frames, const PoolHandle& pool, StageTimes& times) {
  times[Stage::kModulate] += demodulate(frames, Demodulation::kAlbedo, pool, samples_);
  std::swap(I_prev2_, history_prev_.I);
  std::swap(history_, history_prev_);
  std::swap(fast_I_prev2_, fast_prev_.I);
  std::swap(fast_, fast_prev_);
  times[Stage::kTemporal] +=
      accumulate(frames, samples_, accumulation_, history_prev_, &I_prev2_, pool, history_);
  times[Stage::kTemporal] +=
      accumulateFast(frames, samples_, static_cast<float>(params_.fast_history), history_.length,
                     history_prev_.length, fast_prev_, fast_I_prev2_, pool, fast_);
  times[Stage::kTemporal] += clampHistory(fast_, params_.clamp, pool, history_);
}

void Relax::filter(const FramePair& frames, const PoolHandle& pool, StageTimes& times) {
  times[Stage::kVariance] += estimateVariance(frames, history_, variance_, pool, filtered_);
  if (params_.anti_firefly) {
    times[Stage::kVariance] += removeFireflies(frames, filtered_, pool, scratch_);
    std::swap(filtered_, scratch_);
  }
  for (int iteration = 0; iteration < params_.iterations; ++iteration) {
    times[Stage::kAtrous] += atrousIteration(frames, atrous_, 1 << iteration, filtered_, pool, scratch_);
    std::swap(filtered_, scratch_);
  }
}

}  // namespace saccade
