#include "render/tiles/pair_plan.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "frame/illumination.h"

namespace saccade {
namespace {

constexpr float kAbove = 1.5f;  // times the mean standard deviation
constexpr int kMore = 7;        // times the first pairs
constexpr float kMostMore = 64;

// The mean of value(x, y) over the 3x3 pixels around one that have pairs, by their numbers.
template <class Value>
float meanAround(const ImageF& count, int x, int y, const Value& value) {
  float sum = 0, n = 0;
  for (int v = y - 1; v <= y + 1; ++v)
    for (int u = x - 1; u <= x + 1; ++u)
      if (const float w = count.at(u, v); w > 0) sum += w * value(u, v), n += w;
  return sum / n;
}

// The share of a pixel's pairs in those of the 3x3 pixels around it.
float ownShare(const ImageF& count, int x, int y) {
  float sum = 0;
  for (int v = y - 1; v <= y + 1; ++v)
    for (int u = x - 1; u <= x + 1; ++u) sum += count.at(u, v);
  return count.at(x, y) / sum;
}

}  // namespace

std::chrono::nanoseconds planMorePairs(const Frame& now, const Frame& before, const PoolHandle& pool,
                                       PairSamples& pairs) {
  const int width = now.width(), height = now.height();
  const auto change = [&](int x, int y) {
    return illuminationOf(now.g, x, y, now.samples.I2.at(x, y)) -
           illuminationOf(before.g, x, y, pairs.before.at(x, y));
  };
  const auto deviation = [&](int x, int y) {  // of radiance
    return now.g.albedo.at(x, y) * std::sqrt(pairs.variance.at(x, y));
  };
  // The square of what a change differs by from the mean around it, of which it is a share itself.
  ImageF apart(width, height);
  auto time = pool.forEachRow(height, [&](int y) {
    for (int x = 0; x < width; ++x)
      if (const float n = pairs.count.at(x, y); n > 0) {
        const float d = change(x, y) - meanAround(pairs.count, x, y, change);
        const float own = ownShare(pairs.count, x, y);
        apart.at(x, y) = own < 1 ? d * d * n / (1 - own) : 0;
      }
  });
  std::vector<double> deviations(static_cast<std::size_t>(height)), pixels(deviations.size());
  time += pool.forEachRow(height, [&](int y) {
    const auto row = static_cast<std::size_t>(y);
    for (int x = 0; x < width; ++x) {
      if (pairs.count.at(x, y) <= 0) continue;
      float& variance = pairs.variance.at(x, y);
      variance = meanAround(pairs.count, x, y, [&](int u, int v) { return apart.at(u, v); });
      deviations[row] += deviation(x, y), pixels[row] += 1;
    }
  });
  double sum = 0, n = 0;
  for (std::size_t y = 0; y < pixels.size(); ++y) sum += deviations[y], n += pixels[y];
  const float limit = n > 0 ? kAbove * static_cast<float>(sum / n) : 0;
  return time + pool.forEachRow(height, [&](int y) {
    for (int x = 0; x < width; ++x)
      if (const float first = pairs.count.at(x, y);
          first > 0 && (deviation(x, y) > limit || ownShare(pairs.count, x, y) == 1))
        pairs.more.at(x, y) = std::min(kMore * first, kMostMore);
  });
}

void addPairs(std::span<const std::array<float, 2>> further, int x, int y, const GBuffer& g_now,
              const GBuffer& g_before, FrameSamples& samples, PairSamples& pairs) {
  const auto n = static_cast<float>(further.size());
  const float A_now = divisorOf(g_now, x, y), A_before = divisorOf(g_before, x, y);
  float sum_now = 0, sum_before = 0;
  for (const auto& [now, before] : further) sum_now += now, sum_before += before;
  const float mean = (sum_now / A_now - sum_before / A_before) / n;
  float squares = 0;
  for (const auto& [now, before] : further) {
    const float apart = now / A_now - before / A_before - mean;
    squares += apart * apart;
  }
  float& count = pairs.count.at(x, y);
  const auto add = [&](float E, float sum, float& I) { I = E + ((I - E) * count + sum) / (count + n); };
  add(g_now.emission.at(x, y), sum_now, samples.I2.at(x, y));
  add(g_before.emission.at(x, y), sum_before, pairs.before.at(x, y));
  pairs.variance.at(x, y) = squares / std::max(n - 1, 1.f);
  count += n;
}

}  // namespace saccade
