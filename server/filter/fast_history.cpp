#include "filter/fast_history.h"

#include <algorithm>
#include <cmath>

#include "filter/reprojection.h"
#include "filter/surface_test.h"

namespace saccade {
namespace {

constexpr int kRadius = 2;

struct Range {
  float clamped(float v) const { return std::clamp(v, low, high); }
  float low, high;
};

// Of the mean around a pixel, inside the picture.
Range rangeAround(const ImageF& plane, int x, int y, float deviations) {
  float n = 0, sum = 0, squares = 0;
  const float centre = plane.at(x, y);  // so that squares keep their digits
  for (int v = std::max(y - kRadius, 0); v <= std::min(y + kRadius, plane.height() - 1); ++v) {
    const float* row = plane.row(v);
    for (int u = std::max(x - kRadius, 0); u <= std::min(x + kRadius, plane.width() - 1); ++u) {
      const float apart = row[u] - centre;
      n += 1, sum += apart, squares += apart * apart;
    }
  }
  const float mean = sum / n;
  const float reach = deviations * std::sqrt(std::max(squares / n - mean * mean, 0.f));
  return {centre + mean - reach, centre + mean + reach};
}

}  // namespace

std::chrono::nanoseconds accumulateFast(const FramePair& frames, const IlluminationSamples& samples,
                                        float most, const ImageF& length, const ImageF& length_prev,
                                        const FastHistory& prev, const ImageF& I_prev2,
                                        const PoolHandle& pool, FastHistory& out) {
  const GBuffer &g = frames.cur.g, &g_prev = frames.prev.g;
  return pool.forEachRow(length.height(), [&](int y) {
    for (int x = 0; x < length.width(); ++x) {
      const Reprojection W = Reprojection::find(g, g_prev, x, y, SameSurface(g, g_prev, x, y));
      const float alpha = W.found() ? 1 / std::min(most, length.at(x, y)) : 1;
      const float d = samples.d.at(x, y), R = W(prev.I);
      out.R.at(x, y) = R;
      out.I.at(x, y) = R + alpha * (samples.i.at(x, y) - R);
      // [E (16)], as in accumulate().
      const float carried = W(prev.D) + W(I_prev2) - prev.R.at(x, y);
      const bool history = W.found() && length_prev.at(x, y) > 1;
      out.D.at(x, y) = history ? carried + alpha * (d - carried) : d;
    }
  });
}

std::chrono::nanoseconds clampHistory(const FastHistory& fast, float deviations, const PoolHandle& pool,
                                      History& history) {
  return pool.forEachRow(history.I.height(), [&](int y) {
    for (int x = 0; x < history.I.width(); ++x) {
      history.I.at(x, y) = rangeAround(fast.I, x, y, deviations).clamped(history.I.at(x, y));
      history.D.at(x, y) = rangeAround(fast.D, x, y, deviations).clamped(history.D.at(x, y));
    }
  });
}

}  // namespace saccade
