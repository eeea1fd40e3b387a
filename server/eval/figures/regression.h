// Fits straight lines to measured points.
#pragma once

#include <vector>

namespace saccade::eval {

struct Sample {
  double x, y;
};

struct Regression {
  double slope;
  double r2;  // 1 - sum (y - fit)^2 / sum (y - mean y)^2: at most 1, and below 0 if the mean would fit better
};

// Least squares of y = slope x. NaN without a sample whose x is not 0.
Regression throughOrigin(const std::vector<Sample>& samples);

// Least squares of log y = c + slope log x: the slope is the exponent of a power law, and r2 that of the
// logarithms. Leaves out samples that are not above 0 in both. NaN without two
// different x.
Regression powerLaw(const std::vector<Sample>& samples);

}  // namespace saccade::eval
