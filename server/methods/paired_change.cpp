#include "methods/paired_change.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "filter/atrous.h"
#include "filter/reprojection.h"
#include "filter/surface_test.h"

namespace saccade {
namespace {

constexpr int kIterations = 2;
constexpr AtrousParams kAtrous{.sigma_n = 16, .sigma_l_diff = 6};
// The filter takes errors of neighbours for independent, but stays within few of them.
constexpr float kFilteredVariance = 2;
constexpr float kLeastVariance = 0.05f;  // of a joined change, relative to that of the frame alone
constexpr int kAround = 2;               // pixels on each side, in which both changes are compared

bool hasPairs(const PairSamples& pairs, int x, int y) {
  return pairs.count.at(x, y) > 0;
}

// The variance of a pixel's mean. It is pooled over the pixels around that have more pairs, too, or have
// not: where few have more, the others tell little of their noise.
float varianceOfMean(const PairSamples& pairs, int x, int y) {
  const bool more = pairs.more.at(x, y) > 0;
  float sum = 0, n = 0;
  for (int v = y - 1; v <= y + 1; ++v)
    for (int u = x - 1; u <= x + 1; ++u)
      if (hasPairs(pairs, u, v) && (pairs.more.at(u, v) > 0) == more) sum += pairs.variance.at(u, v), n += 1;
  return sum / n / pairs.count.at(x, y);
}

}  // namespace

PairedChange::PairedChange(int w, int h)
    : filtered_(w, h), scratch_(w, h), last_(w, h), var_last_(w, h), carried_(w, h), var_carried_(w, h) {}

void PairedChange::estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& change,
                            StageTimes& times) {
  SACCADE_CHECK(frames.cur.pairs != nullptr);
  const PairSamples& pairs = *frames.cur.pairs;
  gather(frames, change, pool, times);
  for (int k = 0; k < kIterations; ++k) {
    times[Stage::kAtrous] += atrousIteration(frames, kAtrous, 1 << k, filtered_, pool, scratch_);
    std::swap(filtered_, scratch_);
  }
  join(frames, pool, times);
  times[Stage::kModulate] += pool.forEachRow(change.dI.height(), [&](int y) {
    for (int x = 0; x < change.dI.width(); ++x) {
      if (!hasPairs(pairs, x, y)) continue;
      change.dI.at(x, y) =
          last_.at(x, y) + (frames.cur.g.emission.at(x, y) - frames.prev.g.emission.at(x, y));
      change.var_dI.at(x, y) = var_last_.at(x, y);
    }
  });
}

void PairedChange::gather(const FramePair& frames, const IntensityChange& change, const PoolHandle& pool,
                          StageTimes& times) {
  const PairSamples& pairs = *frames.cur.pairs;
  times[Stage::kVariance] += pool.forEachRow(change.dI.height(), [&](int y) {
    for (int x = 0; x < change.dI.width(); ++x) {
      const bool own = hasPairs(pairs, x, y);
      const float all = own ? frames.cur.samples.I2.at(x, y) - pairs.before.at(x, y) : change.dI.at(x, y);
      filtered_.d.at(x, y) = all - (frames.cur.g.emission.at(x, y) - frames.prev.g.emission.at(x, y));
      filtered_.var_d.at(x, y) = own ? varianceOfMean(pairs, x, y) : change.var_dI.at(x, y);
    }
  });
}

// D <- D + w (C - D), w = v / (v + v_c + b^2): C is the last change along the motion vectors, v and v_c are
// the variances, and b^2 is by how much both differ beyond these. A reflection that does not follow its
// surface has a large b.
void PairedChange::join(const FramePair& frames, const PoolHandle& pool, StageTimes& times) {
  const PairSamples& pairs = *frames.cur.pairs;
  const int width = last_.width(), height = last_.height();
  const GBuffer &g = frames.cur.g, &g_prev = frames.prev.g;
  times[Stage::kTemporal] += pool.forEachRow(height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      var_carried_.at(x, y) = -1;
      if (!hasPairs(pairs, x, y)) continue;
      filtered_.var_d.at(x, y) *= kFilteredVariance;
      if (!has_last_) continue;
      const Reprojection W = Reprojection::find(g, g_prev, x, y, SameSurface(g, g_prev, x, y));
      if (W.found()) carried_.at(x, y) = W(last_), var_carried_.at(x, y) = W(var_last_);
    }
  });
  const auto beyondNoise = [&](int x, int y) {
    float sum = 0, n = 0;
    for (int v = std::max(y - kAround, 0); v <= std::min(y + kAround, height - 1); ++v)
      for (int u = std::max(x - kAround, 0); u <= std::min(x + kAround, width - 1); ++u) {
        const float var_c = var_carried_.at(u, v), apart = filtered_.d.at(u, v) - carried_.at(u, v);
        if (var_c >= 0) sum += apart * apart - filtered_.var_d.at(u, v) - var_c, n += 1;
      }
    return std::max(sum / n, 0.f);
  };
  times[Stage::kTemporal] += pool.forEachRow(height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const float d = filtered_.d.at(x, y), v = filtered_.var_d.at(x, y), v_c = var_carried_.at(x, y);
      last_.at(x, y) = d, var_last_.at(x, y) = v;
      if (v_c < 0 || v <= 0) continue;
      const float w = v / (v + v_c + beyondNoise(x, y));
      last_.at(x, y) = d + w * (carried_.at(x, y) - d);
      var_last_.at(x, y) = std::max((1 - w) * (1 - w) * v + w * w * v_c, kLeastVariance * v);
    }
  });
  has_last_ = true;
}

}  // namespace saccade
