#include "eval/metrics/repeats.h"

#include <cmath>

#include "eval/metrics/for_each_pixel.h"

namespace saccade::eval {

// Welford's update: nothing cancels, however small the noise is beside the mean.
void Repeats::add(const ImageF& x) {
  checkSameSize(x, mean_);
  ++count_;
  forEachPixel(x, [&](int column, int row) {
    const double value = x.at(column, row), before = value - mean_.at(column, row);
    mean_.at(column, row) += before / count_;
    squares_.at(column, row) += before * (value - mean_.at(column, row));
  });
}

double Repeats::variance(int x, int y) const {
  SACCADE_CHECK(count_ >= 2);
  return squares_.at(x, y) / (count_ - 1);
}

ImageF Repeats::sigma() const {
  ImageF sigma(width(), height());
  forEachPixel(sigma, [&](int x, int y) { sigma.at(x, y) = static_cast<float>(std::sqrt(variance(x, y))); });
  return sigma;
}

}  // namespace saccade::eval
