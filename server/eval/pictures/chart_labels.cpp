#include "eval/pictures/chart_labels.h"

#include <algorithm>

namespace saccade::eval {
namespace {

constexpr double kCharWidth = 0.55 * kLabelSize, kLineHeight = 0.8 * kLabelSize, kMarkRadius = 3;
constexpr double kBeside = 5, kAbove = -4, kBelow = 10;  // from the point to the label, pixels

}  // namespace

void LabelPlaces::avoid(double x, double y) {
  taken_.push_back({x - kMarkRadius, x + kMarkRadius, y - kMarkRadius, y + kMarkRadius});
}

std::optional<LabelPlaces::Corner> LabelPlaces::take(double x, double y, const std::string& label) {
  const double width = kCharWidth * static_cast<double>(label.size());
  for (const double left : {x + kBeside, x - kBeside - width}) {
    for (const double baseline : {y + kAbove, y + kBelow}) {
      const Box box{left, left + width, baseline - kLineHeight, baseline};
      const auto overlaps = [&](const Box& other) {
        return other.left < box.right && box.left < other.right && other.top < box.bottom &&
               box.top < other.bottom;
      };
      if (std::any_of(taken_.begin(), taken_.end(), overlaps)) continue;
      taken_.push_back(box);
      return Corner{left, baseline};
    }
  }
  return std::nullopt;
}

}  // namespace saccade::eval
