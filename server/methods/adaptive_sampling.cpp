#include "methods/adaptive_sampling.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "methods/param_fields.h"

namespace saccade {
namespace {

using P = AdaptiveSamplingParams;

// A round is 1/64 of the paths, and four rounds come before the first test: 64 and 256 of 4096, as published.
constexpr int kRounds = 64, kFirstRounds = 4;

const std::vector<ParamField<P>>& fields() {
  static const std::vector<ParamField<P>> table{
      {"threshold", &P::threshold, 0.001, 10, "of an event that the test decides, natural log units",
       "[ours] that of a sensor by default; published: 0.5, 0.6 or 3, by the scene"},
      {"bias", &P::bias, 1e-12, 1e12, "added to light before its logarithm, scene luminance [E (1)]",
       "[ours] that of a sensor by default"},
      {"hold", &P::hold, 0, 1,
       "1: a pixel keeps its light until the test decides an event, as published; 0: it shows each frame's",
       "[ours] sensors of any threshold need the change itself"},
      independentNumbersField<P>(&P::independent_numbers),
  };
  return table;
}

}  // namespace

MethodInfo AdaptiveSampling::info() {
  return {"adaptive_sampling",
          "path tracing that stops at a pixel once a t-test decides its event; --spp is the most it may take",
          paramSpecs(fields()),
          [](const ParamValues& values) -> SeedPlanner {
            return seedsWith<SeedPlan::independent>(makeParams(fields(), values).independent_numbers);
          },
          [](const MethodSetup& setup) -> std::unique_ptr<Method> {
            return std::make_unique<AdaptiveSampling>(makeParams(fields(), setup.params), setup.width,
                                                      setup.height);
          }};
}

AdaptiveSampling::AdaptiveSampling(const P& params, int w, int h)
    : params_(params),
      wanted_(w, h),
      sum_(w, h),
      log_sum_(w, h),
      log_squares_(w, h),
      rounds_(w, h),
      last_mean_(w, h),
      last_var_(w, h),
      last_rounds_(w, h),
      held_(w, h),
      I_prev_(w, h),
      var_I_prev_(w, h) {}

BrightnessMean AdaptiveSampling::brightness(int x, int y) const {
  return BrightnessMean::of(log_sum_.at(x, y), log_squares_.at(x, y), static_cast<float>(rounds_.at(x, y)));
}

bool AdaptiveSampling::undecided(int x, int y) const {
  if (first_ || round_ < kFirstRounds) return true;
  const BrightnessMean last{last_mean_.at(x, y), last_var_.at(x, y), last_rounds_.at(x, y)};
  return wanted_.at(x, y) && !testEvent(brightness(x, y), last, params_.threshold).certain;
}

int AdaptiveSampling::nextRound(int spp, const PoolHandle& pool) {
  if (round_ == 0)
    for (ImageF* plane : {&sum_, &log_sum_, &log_squares_}) plane->fill(0);
  if (round_ == 0) rounds_.fill(0);
  const int paths = std::max(spp / kRounds, 1);
  if (round_ == std::min(kRounds, spp / paths)) return round_ = 0;
  std::atomic<bool> any = false;
  pool.forEachRow(sum_.height(), [&](int y) {
    bool row = false;
    for (int x = 0; x < sum_.width(); ++x) row |= wanted_.at(x, y) = undecided(x, y);
    if (row) any = true;
  });
  if (!any) return round_ = 0;
  ++round_;
  return paths;
}

void AdaptiveSampling::take(Frame& frame, const PoolHandle& pool) {
  ImageF& I = frame.samples.I2;
  pool.forEachRow(sum_.height(), [&](int y) {
    for (int x = 0; x < sum_.width(); ++x) {
      if (!wanted_.at(x, y)) continue;
      const float light = std::clamp(I.at(x, y), 0.f, 1e30f), brightness = std::log(params_.bias + light);
      sum_.at(x, y) += light, log_sum_.at(x, y) += brightness;
      log_squares_.at(x, y) += brightness * brightness;
      I.at(x, y) = sum_.at(x, y) / static_cast<float>(++rounds_.at(x, y));
    }
  });
}

void AdaptiveSampling::start(const Frame& first, const PoolHandle& pool) {
  I_prev_.copyFrom(first.samples.I2);
  held_.copyFrom(first.samples.I2);
  keepEvents(true, pool);
  first_ = false;
}

void AdaptiveSampling::keepEvents(bool all, const PoolHandle& pool) {
  pool.forEachRow(sum_.height(), [&](int y) {
    for (int x = 0; x < sum_.width(); ++x) {
      const BrightnessMean now = brightness(x, y);
      const BrightnessMean last{last_mean_.at(x, y), last_var_.at(x, y), last_rounds_.at(x, y)};
      if (!all && !testEvent(now, last, params_.threshold).event) continue;
      last_mean_.at(x, y) = now.mean, last_var_.at(x, y) = now.variance, last_rounds_.at(x, y) = now.samples;
      held_.at(x, y) = sum_.at(x, y) / now.samples;
    }
  });
}

void AdaptiveSampling::estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                                StageTimes& times) {
  keepEvents(false, pool);
  const ImageF& I = params_.hold ? held_ : frames.cur.samples.I2;
  times[Stage::kModulate] += pool.forEachRow(sum_.height(), [&](int y) {
    for (int x = 0; x < sum_.width(); ++x) {
      const float now = I.at(x, y), before = I_prev_.at(x, y), scale = params_.bias + now;
      const float var = params_.hold ? 0 : scale * scale * brightness(x, y).variance;
      out.I_now.at(x, y) = now, out.I_prev.at(x, y) = before, out.dI.at(x, y) = now - before;
      out.var_I_prev.at(x, y) = var_I_prev_.at(x, y), out.var_dI.at(x, y) = var + var_I_prev_.at(x, y);
      I_prev_.at(x, y) = now, var_I_prev_.at(x, y) = var;
    }
  });
}

}  // namespace saccade
