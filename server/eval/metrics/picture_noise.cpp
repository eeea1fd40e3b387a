#include "eval/metrics/picture_noise.h"

#include <cmath>

#include "base/vec.h"
#include "eval/metrics/for_each_pixel.h"

namespace saccade::eval {
namespace {

double luminanceAt(const RgbPlanes& planes, int x, int y) {
  return luminance({planes[0].at(x, y), planes[1].at(x, y), planes[2].at(x, y)});
}

}  // namespace

double relativeNoise(const RgbPlanes& picture, const RgbPlanes& reference) {
  checkSameSize(picture[0], reference[0]);
  double squares = 0, light = 0;
  forEachPixel(reference[0], [&](int x, int y) {
    const double truth = luminanceAt(reference, x, y), error = luminanceAt(picture, x, y) - truth;
    squares += error * error;
    light += truth;
  });
  if (squares == 0) return 0;
  const double pixels = static_cast<double>(reference[0].width()) * reference[0].height();
  return std::sqrt(squares * pixels) / light;
}

}  // namespace saccade::eval
