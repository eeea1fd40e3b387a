#include "eval/metrics/noise_free_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "eval/metrics/for_each_pixel.h"

namespace saccade::eval {
namespace {

double over(double sum, double truth) {
  return truth > 0 ? sum / truth : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

void NoiseFreeError::add(const ImageF& x, const ImageF& a, const ImageF& b) {
  checkSameSize(x, a), checkSameSize(x, b);
  forEachPixel(x, [&](int column, int row) {
    const double value = x.at(column, row), in_a = a.at(column, row), in_b = b.at(column, row);
    error_ += (value - in_a) * (value - in_b);
    arrived_ += value * (in_a + in_b) / 2;
    truth_ += in_a * in_b;
  });
}

double NoiseFreeError::relative() const {
  return std::sqrt(over(std::max(error_, 0.0), truth_));
}

double NoiseFreeError::share() const {
  return over(arrived_, truth_);
}

}  // namespace saccade::eval
