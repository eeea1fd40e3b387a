#include "eval/tasks/correlation.h"

#include <cmath>

#include "eval/metrics/for_each_pixel.h"

namespace saccade::eval {
namespace {

double meanOf(const ImageF& image) {
  double sum = 0;
  forEachPixel(image, [&](int x, int y) { sum += image.at(x, y); });
  return sum / image.width() / image.height();
}

}  // namespace

double correlation(const ImageF& a, const ImageF& b) {
  checkSameSize(a, b);
  const double mean_a = meanOf(a), mean_b = meanOf(b);
  double aa = 0, bb = 0, ab = 0;
  forEachPixel(a, [&](int x, int y) {
    const double da = a.at(x, y) - mean_a, db = b.at(x, y) - mean_b;
    aa += da * da, bb += db * db, ab += da * db;
  });
  return ab / std::sqrt(aa * bb);
}

}  // namespace saccade::eval
