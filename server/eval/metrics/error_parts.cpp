#include "eval/metrics/error_parts.h"

#include <cmath>

#include "eval/metrics/for_each_pixel.h"

namespace saccade::eval {
namespace {

double signedRoot(double square) {
  return std::copysign(std::sqrt(std::abs(square)), square);
}

// Calls visit(x, y) for the pixels in any of the regions `which`; returns their number.
template <class Visit>
double forEachIn(const RegionMap& regions, std::uint32_t which, Visit visit) {
  double pixels = 0;
  forEachPixel(regions, [&](int x, int y) {
    if (!(regions.at(x, y) & which)) return;
    visit(x, y);
    ++pixels;
  });
  return pixels;
}

void checkHalves(const RegionMap& regions, const ImageF& a, const ImageF& b) {
  checkSameSize(regions, a);
  checkSameSize(regions, b);
}

}  // namespace

ErrorParts errorParts(const Repeats& x, const ImageF& a, const ImageF& b, const RegionMap& regions,
                      std::uint32_t which) {
  checkHalves(regions, a, b);
  SACCADE_CHECK(x.width() == a.width() && x.height() == a.height());
  double bias = 0, noise = 0, offset = 0;
  const double pixels = forEachIn(regions, which, [&](int column, int row) {
    const double to_a = x.mean(column, row) - a.at(column, row),
                 to_b = x.mean(column, row) - b.at(column, row);
    const double variance = x.variance(column, row);
    bias += to_a * to_b - variance / x.count();  // less the noise that the mean of the repeats still has
    noise += variance;
    offset += (to_a + to_b) / 2;
  });
  bias /= pixels, noise /= pixels;
  return {signedRoot(bias + noise), signedRoot(bias), std::sqrt(noise), offset / pixels};
}

double rmsError(const ImageF& x, const ImageF& a, const ImageF& b, const RegionMap& regions,
                std::uint32_t which) {
  checkHalves(regions, a, b);
  checkSameSize(x, a);
  double sum = 0;
  const double pixels = forEachIn(regions, which, [&](int column, int row) {
    const double value = x.at(column, row);
    sum += (value - a.at(column, row)) * (value - b.at(column, row));
  });
  return signedRoot(sum / pixels);
}

}  // namespace saccade::eval
