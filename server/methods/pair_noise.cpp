#include "methods/pair_noise.h"

#include <algorithm>

#include "frame/illumination.h"
#include "methods/pixels_around.h"

namespace saccade {

// It is pooled over those around that have more pairs, too, or have not: where few have more, the others tell
// little of their noise.
float varianceOfChange(const PairSamples& pairs, int x, int y) {
  const bool more = pairs.more.at(x, y) > 0;
  float sum = 0, n = 0;
  forEachAround(pairs.count, x, y, 1, [&](int u, int v) {
    if (hasPairs(pairs, u, v) && (pairs.more.at(u, v) > 0) == more) sum += pairs.variance.at(u, v), n += 1;
  });
  return sum / n / pairs.count.at(x, y);
}

namespace {

// By what those around differ.
template <class Light>
float varianceAroundOf(const PairSamples& pairs, int x, int y, const Light& light) {
  const float here = light(x, y);
  float sum = 0, squares = 0, n = 0;
  forEachAround(pairs.count, x, y, 1, [&](int u, int v) {
    if (!hasPairs(pairs, u, v)) return;
    const float from_this = light(u, v) - here;
    sum += from_this, squares += from_this * from_this, n += 1;
  });
  return n > 1 ? std::max(squares - sum * sum / n, 0.f) / (n - 1) : here * here;
}

}  // namespace

float varianceOfIllumination(const Frame& now, int x, int y) {
  return varianceAroundOf(*now.pairs, x, y,
                          [&](int u, int v) { return illuminationOf(now.g, u, v, now.samples.I2.at(u, v)); });
}

float varianceAround(const CoatSamples& coats, int x, int y) {
  return varianceAroundOf(coats.pairs, x, y, [&](int u, int v) { return coats.now.at(u, v); });
}

float provenChange(float d, float var) {
  constexpr float kDoubt = 0.05f;
  return d * d > kDoubt * var ? d - kDoubt * var / d : 0;
}

}  // namespace saccade
