#include "eval/pictures/chart_labels.h"

#include <algorithm>
#include <cmath>

namespace saccade::eval {
namespace {

constexpr double kCharWidth = 0.55 * kLabelSize, kLineHeight = 0.8 * kLabelSize;
constexpr double kAbove = -4, kBelow = 10;  // from the point to the baseline, pixels

}  // namespace

std::optional<double> LabelPlaces::take(double x, double y, const std::string& label) {
  const double right = x + kCharWidth * static_cast<double>(label.size());
  for (const double baseline : {y + kAbove, y + kBelow}) {
    const auto overlaps = [&](const Place& place) {
      return place.left < right && x < place.right && std::abs(place.baseline - baseline) < kLineHeight;
    };
    if (std::any_of(taken_.begin(), taken_.end(), overlaps)) continue;
    taken_.push_back({x, right, baseline});
    return baseline;
  }
  return std::nullopt;
}

}  // namespace saccade::eval
