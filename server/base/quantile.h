// Quantiles of a set of numbers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/check.h"

namespace saccade {

// The value at `fraction` of the ascending order of `values`: 0 gives the least, 0.5 the median, 1 the
// greatest. Between two ranks it takes the lower one. `values` must hold a number and no NaN; reorders them.
template <class T>
T quantile(std::vector<T>& values, double fraction) {
  SACCADE_CHECK(!values.empty() && fraction >= 0 && fraction <= 1);
  const auto rank = static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

}  // namespace saccade
