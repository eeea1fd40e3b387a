// Finds places for the labels of points, so that none covers another label or a mark.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace saccade::eval {

inline constexpr double kLabelSize = 9;  // of the font, pixels

class LabelPlaces {
 public:
  struct Corner {
    double left, baseline;
  };
  // Keeps labels off the mark at (x, y).
  void avoid(double x, double y);
  // Takes a place for the label of the point (x, y): to the right or left of it, above or below. Returns
  // nothing where all four are taken.
  std::optional<Corner> take(double x, double y, const std::string& label);

 private:
  struct Box {
    double left, right, top, bottom;
  };
  std::vector<Box> taken_;
};

}  // namespace saccade::eval
