#include "eval/metrics/plane_error.h"

#include <cmath>
#include <limits>

#include "eval/metrics/for_each_pixel.h"

namespace saccade::eval {
namespace {

double size(const ImageF& ref) {
  double sum = 0;
  forEachPixel(ref, [&](int x, int y) { sum += std::abs(static_cast<double>(ref.at(x, y))); });
  return sum;
}

// error / scale; at scale 0 it is 0 for no error, else infinite.
double ratio(double error, double scale) {
  if (scale == 0) return error == 0 ? 0 : error * std::numeric_limits<double>::infinity();
  return error / scale;
}

}  // namespace

double relativeL1(const ImageF& x, const ImageF& ref) {
  checkSameSize(x, ref);
  double error = 0;
  forEachPixel(ref, [&](int column, int row) {
    error += std::abs(static_cast<double>(x.at(column, row)) - ref.at(column, row));
  });
  return ratio(error, size(ref));
}

double mape(const ImageF& x, const ImageF& ref) {
  checkSameSize(x, ref);
  const double pixels = static_cast<double>(ref.width()) * ref.height();
  const double floor = kMapeFloor * size(ref) / pixels;
  double sum = 0;
  forEachPixel(ref, [&](int column, int row) {
    const double truth = ref.at(column, row);
    sum += ratio(std::abs(x.at(column, row) - truth), std::abs(truth) + floor);
  });
  return sum / pixels;
}

}  // namespace saccade::eval
