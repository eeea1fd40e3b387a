#include "events/models/first_passage.h"

#include <algorithm>
#include <cmath>

#include "events/noise/noise_numbers.h"

namespace saccade {
namespace {

struct Barriers {
  double on, off;
  double width() const { return on + off; }
  bool inside(double v) const { return v > -off && v < on; }
  double nearest(double v) const { return 2 * v > on - off ? on : -off; }
};

// A bridge from (from, v0) to (to, v1), with this variance over its time.
struct Bridge {
  double from, to, v0, v1, variance;
};

// exp(), without the time of those that are below 1e-20.
double density(double exponent) {
  return exponent > -46 ? std::exp(exponent) : 0;
}

// The probability that a bridge leaves the barriers. It is the density of a path between absorbing barriers,
// over that of a free one, by images at distances of 2 n width. Where the variance is at most width^2 / 16,
// terms beyond |n| = 1 are below 1e-20.
double passes(const Bridge& bridge, const Barriers& barriers) {
  if (!barriers.inside(bridge.v0) || !barriers.inside(bridge.v1)) return 1;
  const double y0 = bridge.v0 + barriers.off, y1 = bridge.v1 + barriers.off, w = barriers.width();
  double leaves = 0;
  for (int n = -1; n <= 1; ++n) {
    const double back = n * w;
    leaves += density(-2 * (back + y0) * (back + y1) / bridge.variance);
    if (n != 0) leaves -= density(-2 * back * (back + y1 - y0) / bridge.variance);
  }
  return std::clamp(leaves, 0.0, 1.0);
}

// The half in which a bridge that passes a barrier does so first.
Bridge firstHalf(const Bridge& bridge, const Barriers& barriers, NumberRow& numbers) {
  constexpr int kMostTries = 1000;  // on average there is one for each bridge, whether it passes or not
  const double middle = (bridge.from + bridge.to) / 2, half = bridge.variance / 2;
  for (int i = 0;; ++i) {
    const double v = (bridge.v0 + bridge.v1) / 2 + std::sqrt(half / 2) * numbers.gaussian();
    const Bridge left{bridge.from, middle, bridge.v0, v, half}, right{middle, bridge.to, v, bridge.v1, half};
    const double in_left = passes(left, barriers);
    const double in_any = 1 - (1 - in_left) * (1 - passes(right, barriers));
    if (i < kMostTries && numbers.uniform() >= in_any) continue;
    return numbers.uniform() * in_any < in_left ? left : right;
  }
}

Passage passageOf(Bridge bridge, const Barriers& barriers, double resolution, NumberRow& numbers) {
  while (bridge.to - bridge.from > resolution) bridge = firstHalf(bridge, barriers, numbers);
  const double end = barriers.inside(bridge.v1) ? (bridge.v0 + bridge.v1) / 2 : bridge.v1;
  return {true, bridge.to, barriers.nearest(end)};
}

}  // namespace

double NumberRow::uniform() {
  return saccade::uniform(hashKey(key_, taken_++));
}

double NumberRow::gaussian() {
  return saccade::gaussian(hashKey(key_, taken_++));
}

Passage firstPassage(const BrownianPath& path, double on, double off, double resolution, NumberRow& numbers) {
  const Barriers barriers{on, off};
  constexpr double kLargestVariance = 1.0 / 16;  // of a bridge, over width^2
  const double parts =
      std::max(1.0, std::ceil(path.variance / (kLargestVariance * barriers.width() * barriers.width())));
  Bridge bridge{0, 0, path.v, path.v, path.variance / parts};
  for (double part = 1; part <= parts; ++part) {
    bridge = {bridge.to, part / parts, bridge.v1,
              bridge.v1 + path.drift / parts + std::sqrt(bridge.variance) * numbers.gaussian(),
              bridge.variance};
    if (numbers.uniform() < passes(bridge, barriers)) return passageOf(bridge, barriers, resolution, numbers);
  }
  return {false, 1, bridge.v1};
}

}  // namespace saccade
