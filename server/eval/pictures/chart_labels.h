// Where the labels of points go, so that none is written over another.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace saccade::eval {

inline constexpr double kLabelSize = 9;  // of the font, pixels

class LabelPlaces {
 public:
  // Takes a place for `label` to the right of a point at (x, y), above it or else below. Returns its
  // baseline, or nothing where both are taken.
  std::optional<double> take(double x, double y, const std::string& label);

 private:
  struct Place {
    double left, right, baseline;
  };
  std::vector<Place> taken_;
};

}  // namespace saccade::eval
