#include "eval/figures/regression.h"

#include <cmath>

namespace saccade::eval {
namespace {

Sample meanOf(const std::vector<Sample>& samples) {
  Sample sum{0, 0};
  for (const Sample& s : samples) sum.x += s.x, sum.y += s.y;
  const double n = static_cast<double>(samples.size());
  return {sum.x / n, sum.y / n};
}

// r2 of y = offset + slope x.
double r2Of(const std::vector<Sample>& samples, double offset, double slope) {
  const double mean = meanOf(samples).y;
  double left = 0, total = 0;
  for (const Sample& s : samples) {
    left += std::pow(s.y - offset - slope * s.x, 2);
    total += std::pow(s.y - mean, 2);
  }
  return 1 - left / total;
}

// sum x y / sum x^2, both from `origin`.
double slopeAbout(const std::vector<Sample>& samples, Sample origin) {
  double xy = 0, xx = 0;
  for (const Sample& s : samples) {
    xy += (s.x - origin.x) * (s.y - origin.y);
    xx += (s.x - origin.x) * (s.x - origin.x);
  }
  return xy / xx;
}

}  // namespace

Regression throughOrigin(const std::vector<Sample>& samples) {
  const double slope = slopeAbout(samples, {0, 0});
  return {slope, r2Of(samples, 0, slope)};
}

Regression powerLaw(const std::vector<Sample>& samples) {
  std::vector<Sample> logs;
  for (const Sample& s : samples) {
    if (s.x > 0 && s.y > 0) logs.push_back({std::log(s.x), std::log(s.y)});
  }
  const Sample mean = meanOf(logs);
  const double slope = slopeAbout(logs, mean);
  return {slope, r2Of(logs, mean.y - slope * mean.x, slope)};
}

}  // namespace saccade::eval
