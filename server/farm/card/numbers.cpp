#include "farm/card/numbers.h"

#include <algorithm>
#include <cstdint>

namespace saccade::farm {

Numbers::Summary Numbers::summary() const {
  std::vector<double> sorted = all_;
  std::ranges::sort(sorted);
  const std::size_t middle = sorted.size() / 2;
  Summary summary{.min = sorted.front(), .median = sorted[middle], .max = sorted.back()};
  if (sorted.size() % 2 == 0) summary.median = (sorted[middle - 1] + sorted[middle]) / 2;
  const double width = (summary.max - summary.min) / kBins;
  for (const double number : sorted) {
    const double place = width > 0 ? (number - summary.min) / width : 0;
    ++summary.bins[std::min(static_cast<std::size_t>(place), kBins - 1)];
  }
  return summary;
}

}  // namespace saccade::farm
