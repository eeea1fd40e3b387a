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
constexpr AtrousParams kAtrous{.sigma_n = 16, .sigma_l = 6, .sigma_l_diff = 6};
// The filter takes errors of neighbours for independent, and its choice of them lessens the variance.
constexpr float kFilteredVariance = 2;
constexpr float kLightVariance = 8;      // the same for light: its history has less noise
constexpr float kLeastVariance = 0.05f;  // of a joined change, relative to that of the frame alone
constexpr int kAround = 2;               // pixels on each side, in which two estimates are compared

bool hasPairs(const PairSamples& pairs, int x, int y) {
  return pairs.count.at(x, y) > 0;
}

// Calls f(u, v) for the pixels around one, and for itself.
template <class F>
void forEachAround(const ImageF& plane, int x, int y, int distance, const F& f) {
  for (int v = std::max(y - distance, 0); v <= std::min(y + distance, plane.height() - 1); ++v)
    for (int u = std::max(x - distance, 0); u <= std::min(x + distance, plane.width() - 1); ++u) f(u, v);
}

// The variance of the mean of a pixel's pairs. It is pooled over those around that have more pairs, too, or
// have not: where few have more, the others tell little of their noise.
float varianceOfChange(const PairSamples& pairs, int x, int y) {
  const bool more = pairs.more.at(x, y) > 0;
  float sum = 0, n = 0;
  forEachAround(pairs.count, x, y, 1, [&](int u, int v) {
    if (hasPairs(pairs, u, v) && (pairs.more.at(u, v) > 0) == more) sum += pairs.variance.at(u, v), n += 1;
  });
  return sum / n / pairs.count.at(x, y);
}

// The variance of a pixel's light, by those around it.
float varianceOfLight(const PairSamples& pairs, const ImageF& light, int x, int y) {
  float sum = 0, squares = 0, n = 0;
  forEachAround(light, x, y, 1, [&](int u, int v) {
    if (!hasPairs(pairs, u, v)) return;
    const float from_this = light.at(u, v) - light.at(x, y);
    sum += from_this, squares += from_this * from_this, n += 1;
  });
  return n > 1 ? std::max(squares - sum * sum / n, 0.f) / (n - 1) : light.at(x, y) * light.at(x, y);
}

// An estimate of variance `var` and another one are joined. Returns the weight of the other:
//   var / (var + var_other + b^2).
// b^2 is by how much both differ around the pixel beyond their noise. For each pixel, the call of
// apart(u, v, sum, n) adds the square of what they differ by, less both variances.
template <class Apart>
float weightOfOther(const ImageF& plane, int x, int y, float var, float var_other, const Apart& apart) {
  float sum = 0, n = 0;
  forEachAround(plane, x, y, kAround, [&](int u, int v) { apart(u, v, sum, n); });
  const float all = var + var_other + std::max(sum / n, 0.f);
  return all > 0 ? var / all : 0;
}

constexpr float kNone = -1;  // instead of a variance

// A change that its noise may have made is none, or it would be an event where nothing happens. It is the
// positive part of James and Stein (1961), with less of the noise.
float proven(float d, float var) {
  constexpr float kDoubt = 0.05f;
  return d * d > kDoubt * var ? d - kDoubt * var / d : 0;
}

}  // namespace

PairedChange::PairedChange(int w, int h)
    : filtered_(w, h), scratch_(w, h), last_(w, h), var_last_(w, h), carried_(w, h), var_carried_(w, h) {}

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
  const PairSamples& pairs = *frames.cur.pairs;
  times[Stage::kModulate] += pool.forEachRow(change.dI.height(), [&](int y) {
    for (int x = 0; x < change.dI.width(); ++x) {
      if (!hasPairs(pairs, x, y)) continue;
      change.dI.at(x, y) = proven(last_.at(x, y), var_last_.at(x, y)) +
                           (frames.cur.g.emission.at(x, y) - frames.prev.g.emission.at(x, y));
      change.var_dI.at(x, y) = var_last_.at(x, y);
    }
  });
}

void PairedChange::gather(const FramePair& frames, const IntensityChange& change, const PoolHandle& pool,
                          StageTimes& times) {
  const PairSamples& pairs = *frames.cur.pairs;
  const ImageF &E = frames.cur.g.emission, &E_prev = frames.prev.g.emission, &I = frames.cur.samples.I2;
  times[Stage::kVariance] += pool.forEachRow(change.dI.height(), [&](int y) {
    for (int x = 0; x < change.dI.width(); ++x) {
      const bool own = hasPairs(pairs, x, y);
      filtered_.i.at(x, y) = (own ? I : change.I_now).at(x, y) - E.at(x, y);
      filtered_.var_i.at(x, y) = own ? varianceOfLight(pairs, I, x, y) : change.var_I_prev.at(x, y);
      filtered_.d.at(x, y) =
          (own ? I.at(x, y) - pairs.before.at(x, y) : change.dI.at(x, y)) - (E.at(x, y) - E_prev.at(x, y));
      filtered_.var_d.at(x, y) = own ? varianceOfChange(pairs, x, y) : change.var_dI.at(x, y);
    }
  });
}

// The light before, as the pairs know it, and as `change` knows it by its history.
void PairedChange::joinBefore(const FramePair& frames, const PoolHandle& pool, IntensityChange& change,
                              StageTimes& times) {
  const PairSamples& pairs = *frames.cur.pairs;
  const ImageF& E_prev = frames.prev.g.emission;
  ImageF &before = carried_, &variance = var_carried_;
  const int width = before.width(), height = before.height();
  times[Stage::kTemporal] += pool.forEachRow(height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      before.at(x, y) = std::max(filtered_.i.at(x, y) - filtered_.d.at(x, y), 0.f) + E_prev.at(x, y);
      variance.at(x, y) = kLightVariance * filtered_.var_i.at(x, y);
    }
  });
  scratch_.i.copyFrom(change.I_prev);
  times[Stage::kTemporal] += pool.forEachRow(height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      if (!hasPairs(pairs, x, y)) continue;
      const float w =
          weightOfOther(before, x, y, variance.at(x, y), 0, [&](int u, int v, float& sum, float& n) {
            if (!hasPairs(pairs, u, v)) return;
            const float apart = before.at(u, v) - scratch_.i.at(u, v);
            sum += apart * apart - variance.at(u, v), n += 1;
          });
      change.I_prev.at(x, y) = before.at(x, y) + w * (scratch_.i.at(x, y) - before.at(x, y));
    }
  });
}

// The change of this frame and that of the last one along the motion vectors. A reflection that does not
// follow its surface makes them differ.
void PairedChange::joinLast(const FramePair& frames, const PoolHandle& pool, StageTimes& times) {
  const PairSamples& pairs = *frames.cur.pairs;
  const int width = last_.width(), height = last_.height();
  const GBuffer &g = frames.cur.g, &g_prev = frames.prev.g;
  times[Stage::kTemporal] += pool.forEachRow(height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      var_carried_.at(x, y) = kNone;
      if (!hasPairs(pairs, x, y)) continue;
      filtered_.var_d.at(x, y) *= kFilteredVariance;
      if (!has_last_) continue;
      const Reprojection W = Reprojection::find(g, g_prev, x, y, SameSurface(g, g_prev, x, y));
      if (W.found()) carried_.at(x, y) = W(last_), var_carried_.at(x, y) = W(var_last_);
    }
  });
  times[Stage::kTemporal] += pool.forEachRow(height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const float d = filtered_.d.at(x, y), var = filtered_.var_d.at(x, y), var_c = var_carried_.at(x, y);
      last_.at(x, y) = d, var_last_.at(x, y) = var;
      if (var_c == kNone) continue;
      const float w = weightOfOther(last_, x, y, var, var_c, [&](int u, int v, float& sum, float& n) {
        if (var_carried_.at(u, v) == kNone) return;
        const float apart = filtered_.d.at(u, v) - carried_.at(u, v);
        sum += apart * apart - filtered_.var_d.at(u, v) - var_carried_.at(u, v), n += 1;
      });
      last_.at(x, y) = d + w * (carried_.at(x, y) - d);
      var_last_.at(x, y) = std::max((1 - w) * (1 - w) * var + w * w * var_c, kLeastVariance * var);
    }
  });
  has_last_ = true;
}

}  // namespace saccade
