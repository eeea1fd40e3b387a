#include "methods/paired_change.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "filter/atrous.h"
#include "filter/demodulation.h"
#include "filter/reprojection.h"
#include "filter/surface_test.h"
#include "frame/illumination.h"
#include "methods/join_estimates.h"
#include "methods/pair_noise.h"

namespace saccade {
namespace {

constexpr int kIterations = 2;
constexpr AtrousParams kAtrous{.sigma_n = 16, .sigma_l = 6, .sigma_l_diff = 6};
// The filter takes errors of neighbours for independent, and its choice of them lessens the variance.
constexpr float kFilteredVariance = 2;
constexpr float kLightVariance = 8;  // the same for light: its history has less noise

}  // namespace

PairedChange::PairedChange(int w, int h)
    : filtered_(w, h),
      scratch_(w, h),
      last_(w, h),
      var_last_(w, h),
      carried_(w, h),
      var_carried_(w, h),
      before_(w, h),
      var_before_(w, h) {}

void PairedChange::estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& change,
                            StageTimes& times) {
  SACCADE_CHECK(frames.cur.pairs != nullptr);
  gather(frames, change, pool, times);
  for (int k = 0; k < kIterations; ++k) {
    times[Stage::kAtrous] += atrousIteration(frames, kAtrous, 1 << k, filtered_, pool, scratch_);
    std::swap(filtered_, scratch_);
  }
  joinBefore(frames, pool, change, times);
  joinLast(frames, pool, times);
  modulate(frames, pool, change, times);
}

void PairedChange::gather(const FramePair& frames, const IntensityChange& change, const PoolHandle& pool,
                          StageTimes& times) {
  const Frame &now = frames.cur, &before = frames.prev;
  const PairSamples& pairs = *now.pairs;
  times[Stage::kVariance] += pool.forEachRow(now.height(), [&](int y) {
    for (int x = 0; x < now.width(); ++x) {
      const bool own = hasPairs(pairs, x, y);
      const float i = illuminationOf(now.g, x, y, (own ? now.samples.I2 : change.I_now).at(x, y));
      const float a = divisorOf(now.g, x, y);
      filtered_.i.at(x, y) = i;
      filtered_.d.at(x, y) =
          i - illuminationOf(before.g, x, y, (own ? pairs.before : change.I_prev).at(x, y));
      filtered_.var_i.at(x, y) =
          own ? varianceOfIllumination(now, x, y) : change.var_I_prev.at(x, y) / (a * a);
      filtered_.var_d.at(x, y) = own ? varianceOfChange(pairs, x, y) : change.var_dI.at(x, y) / (a * a);
    }
  });
}

void PairedChange::joinBefore(const FramePair& frames, const PoolHandle& pool, const IntensityChange& change,
                              StageTimes& times) {
  const PairSamples& pairs = *frames.cur.pairs;
  const EstimatedPlane by_pairs{scratch_.i, scratch_.var_i}, known{carried_, var_carried_};
  times[Stage::kTemporal] += pool.forEachRow(before_.height(), [&](int y) {
    for (int x = 0; x < before_.width(); ++x) {
      scratch_.i.at(x, y) = std::max(filtered_.i.at(x, y) - filtered_.d.at(x, y), 0.f);
      scratch_.var_i.at(x, y) = kLightVariance * filtered_.var_i.at(x, y);
      carried_.at(x, y) = illuminationOf(frames.prev.g, x, y, change.I_prev.at(x, y));
      var_carried_.at(x, y) = hasPairs(pairs, x, y) ? 0 : kNoEstimate;
    }
  });
  times[Stage::kTemporal] += joinEstimates(by_pairs, known, pool, before_, var_before_);
}

void PairedChange::joinLast(const FramePair& frames, const PoolHandle& pool, StageTimes& times) {
  const PairSamples& pairs = *frames.cur.pairs;
  const GBuffer &g = frames.cur.g, &g_prev = frames.prev.g;
  times[Stage::kTemporal] += pool.forEachRow(last_.height(), [&](int y) {
    for (int x = 0; x < last_.width(); ++x) {
      var_carried_.at(x, y) = kNoEstimate;
      if (!hasPairs(pairs, x, y)) continue;
      filtered_.var_d.at(x, y) *= kFilteredVariance;
      if (!has_last_) continue;
      const Reprojection W = Reprojection::find(g, g_prev, x, y, SameSurface(g, g_prev, x, y));
      if (W.found()) carried_.at(x, y) = W(last_), var_carried_.at(x, y) = W(var_last_);
    }
  });
  times[Stage::kTemporal] +=
      joinEstimates({filtered_.d, filtered_.var_d}, {carried_, var_carried_}, pool, last_, var_last_);
  has_last_ = true;
}

void PairedChange::modulate(const FramePair& frames, const PoolHandle& pool, IntensityChange& change,
                            StageTimes& times) const {
  const PairSamples& pairs = *frames.cur.pairs;
  const GBuffer &g = frames.cur.g, &g_prev = frames.prev.g;
  times[Stage::kModulate] += pool.forEachRow(change.dI.height(), [&](int y) {
    for (int x = 0; x < change.dI.width(); ++x) {
      if (!hasPairs(pairs, x, y)) continue;
      const float a = modulationAlbedo(g.albedo.at(x, y), Demodulation::kAlbedo);
      const float a_prev = modulationAlbedo(g_prev.albedo.at(x, y), Demodulation::kAlbedo);
      const float d = last_.at(x, y), var = var_last_.at(x, y), i_prev = before_.at(x, y);
      const float E = g.emission.at(x, y), E_prev = g_prev.emission.at(x, y);
      change.dI.at(x, y) = a * provenChange(d, var) + (a - a_prev) * i_prev + (E - E_prev);
      change.var_dI.at(x, y) = a * a * var;
      change.I_prev.at(x, y) = a_prev * i_prev + E_prev;
    }
  });
}

}  // namespace saccade
