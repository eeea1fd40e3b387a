#include "methods/coat_change.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "filter/atrous.h"
#include "filter/reprojection.h"
#include "filter/surface_test.h"
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

CoatChange::CoatChange(int w, int h)
    : filtered_(w, h),
      scratch_(w, h),
      d_(w, h),
      var_d_(w, h),
      now_(w, h),
      var_now_(w, h),
      before_(w, h),
      var_before_(w, h),
      carried_(w, h),
      var_carried_(w, h) {}

void CoatChange::addTo(IntensityChange& change, const FramePair& frames, const PoolHandle& pool,
                       StageTimes& times) {
  SACCADE_CHECK(frames.cur.coats != nullptr);
  const CoatSamples& coats = *frames.cur.coats;
  gather(coats, pool, times);
  for (int k = 0; k < kIterations; ++k) {
    times[Stage::kAtrous] += atrousIteration(frames, kAtrous, 1 << k, filtered_, pool, scratch_);
    std::swap(filtered_, scratch_);
  }
  joinBefore(coats, pool, times);
  joinLast(frames, pool, times);
  add(coats, pool, change, times);
}

void CoatChange::gather(const CoatSamples& coats, const PoolHandle& pool, StageTimes& times) {
  const PairSamples& pairs = coats.pairs;
  times[Stage::kVariance] += pool.forEachRow(now_.height(), [&](int y) {
    for (int x = 0; x < now_.width(); ++x) {
      const bool any = hasPairs(pairs, x, y);
      filtered_.i.at(x, y) = coats.now.at(x, y);
      filtered_.d.at(x, y) = coats.now.at(x, y) - pairs.before.at(x, y);
      filtered_.var_i.at(x, y) = any ? varianceAround(coats, x, y) : 0;
      filtered_.var_d.at(x, y) = any ? varianceOfChange(pairs, x, y) : 0;
    }
  });
}

void CoatChange::joinBefore(const CoatSamples& coats, const PoolHandle& pool, StageTimes& times) {
  times[Stage::kTemporal] += pool.forEachRow(now_.height(), [&](int y) {
    for (int x = 0; x < now_.width(); ++x) {
      scratch_.i.at(x, y) = std::max(filtered_.i.at(x, y) - filtered_.d.at(x, y), 0.f);
      scratch_.var_i.at(x, y) = kLightVariance * filtered_.var_i.at(x, y);
      if (!has_last_ || !hasPairs(coats.pairs, x, y)) var_now_.at(x, y) = kNoEstimate;
    }
  });
  times[Stage::kTemporal] +=
      joinEstimates({scratch_.i, scratch_.var_i}, {now_, var_now_}, pool, before_, var_before_);
}

void CoatChange::joinLast(const FramePair& frames, const PoolHandle& pool, StageTimes& times) {
  const PairSamples& pairs = frames.cur.coats->pairs;
  const GBuffer &g = frames.cur.g, &g_prev = frames.prev.g;
  times[Stage::kTemporal] += pool.forEachRow(d_.height(), [&](int y) {
    for (int x = 0; x < d_.width(); ++x) {
      var_carried_.at(x, y) = kNoEstimate;
      if (!hasPairs(pairs, x, y)) continue;
      filtered_.var_d.at(x, y) *= kFilteredVariance;
      if (!has_last_) continue;
      const Reprojection W = Reprojection::find(g, g_prev, x, y, SameSurface(g, g_prev, x, y));
      if (W.found()) carried_.at(x, y) = W(d_), var_carried_.at(x, y) = W(var_d_);
    }
  });
  times[Stage::kTemporal] +=
      joinEstimates({filtered_.d, filtered_.var_d}, {carried_, var_carried_}, pool, d_, var_d_);
  has_last_ = true;
}

void CoatChange::add(const CoatSamples& coats, const PoolHandle& pool, IntensityChange& change,
                     StageTimes& times) {
  times[Stage::kModulate] += pool.forEachRow(change.dI.height(), [&](int y) {
    for (int x = 0; x < change.dI.width(); ++x) {
      if (!hasPairs(coats.pairs, x, y)) continue;
      const float before = before_.at(x, y), var = var_before_.at(x, y);
      const float d = std::max(provenChange(d_.at(x, y), var_d_.at(x, y)), -before);
      change.dI.at(x, y) += d;
      change.var_dI.at(x, y) += var_d_.at(x, y);
      change.I_prev.at(x, y) += before;
      change.I_now.at(x, y) += before + d;
      change.var_I_prev.at(x, y) += var;
      now_.at(x, y) = before + d, var_now_.at(x, y) = var + var_d_.at(x, y);
    }
  });
}

}  // namespace saccade
