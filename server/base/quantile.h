// The middle of many numbers, or any other rank.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/check.h"

namespace saccade {

// The value at `fraction` of `values` in ascending order, 0: the least, 1: the greatest, rounded down to a
// rank. Not empty, no NaN; puts them in another order.
template <class T>
T quantile(std::vector<T>& values, double fraction) {
  SACCADE_CHECK(!values.empty() && fraction >= 0 && fraction <= 1);
  const auto rank = static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

}  // namespace saccade
