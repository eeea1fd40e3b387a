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

// By what those around differ.
float varianceOfIllumination(const Frame& now, int x, int y) {
  const ImageF& I = now.samples.I2;
  const float here = illuminationOf(now.g, x, y, I.at(x, y));
  float sum = 0, squares = 0, n = 0;
  forEachAround(I, x, y, 1, [&](int u, int v) {
    if (!hasPairs(*now.pairs, u, v)) return;
    const float from_this = illuminationOf(now.g, u, v, I.at(u, v)) - here;
    sum += from_this, squares += from_this * from_this, n += 1;
  });
  return n > 1 ? std::max(squares - sum * sum / n, 0.f) / (n - 1) : here * here;
}

}  // namespace saccade
