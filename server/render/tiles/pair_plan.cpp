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

// One frame of a pixel's pairs: what it emits, and what its reflected light is divided by.
struct PairDivisor {
  PairDivisor(const GBuffer* g, int x, int y) {
    if (g) emission = g->emission.at(x, y), albedo = divisorOf(*g, x, y);
  }
  float operator()(float I) const { return (I - emission) / albedo; }
  float emission = 0, albedo = 1;
};

}  // namespace

std::chrono::nanoseconds planMorePairs(const PairedLight& light, const PoolHandle& pool) {
  PairSamples& pairs = light.pairs;
  const int width = light.now.width(), height = light.now.height();
  const auto change = [&](int x, int y) {
    return PairDivisor(light.g_now, x, y)(light.now.at(x, y)) -
           PairDivisor(light.g_before, x, y)(pairs.before.at(x, y));
  };
  const auto deviation = [&](int x, int y) {  // of radiance
    return (light.g_now ? light.g_now->albedo.at(x, y) : 1) * std::sqrt(pairs.variance.at(x, y));
  };
  // The square of what a change differs by from the mean around it. The mean holds a ninth of it.
  ImageF apart(width, height);
  auto time = pool.forEachRow(height, [&](int y) {
    for (int x = 0; x < width; ++x)
      if (const float n = pairs.count.at(x, y); n > 0) {
        const float d = change(x, y) - meanAround(pairs.count, x, y, change);
        apart.at(x, y) = d * d * n * 9 / 8;
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
      if (const float first = pairs.count.at(x, y); first > 0 && deviation(x, y) > limit)
        pairs.more.at(x, y) = std::min(kMore * first, kMostMore);
  });
}

void addPairs(std::span<const std::array<float, 2>> further, int x, int y, const PairedLight& light) {
  PairSamples& pairs = light.pairs;
  const auto n = static_cast<float>(further.size());
  const PairDivisor of_now(light.g_now, x, y), of_before(light.g_before, x, y);
  const float A_now = of_now.albedo, A_before = of_before.albedo;
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
  add(of_now.emission, sum_now, light.now.at(x, y));
  add(of_before.emission, sum_before, pairs.before.at(x, y));
  pairs.variance.at(x, y) = squares / std::max(n - 1, 1.f);
  count += n;
}

}  // namespace saccade
