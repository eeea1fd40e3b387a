// Counts against those expected.
#pragma once

#include <cmath>
#include <vector>

namespace saccade::test {

using Histogram = std::vector<double>;

inline constexpr double kScoreOf1In1000 = 3.09;

// Standard normal score of chi-square; bins where few are expected are taken together. Wilson and Hilferty
// 1931.
inline double chiSquareScore(const Histogram& seen, const Histogram& expected) {
  double chi2 = 0, pooled_seen = 0, pooled = 0;
  int bins = 0;
  const auto add = [&](double n, double e) { chi2 += (n - e) * (n - e) / e, ++bins; };
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (expected[i] >= 5)
      add(seen[i], expected[i]);
    else
      pooled_seen += seen[i], pooled += expected[i];
  }
  if (pooled >= 5) add(pooled_seen, pooled);
  if (bins < 2) return 0;
  const double free = bins - 1, k = 2 / (9 * free);
  return (std::cbrt(chi2 / free) - (1 - k)) / std::sqrt(k);
}

}  // namespace saccade::test
