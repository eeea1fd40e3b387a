#include "eval/pictures/difference_picture.h"

#include <algorithm>
#include <cmath>

#include "base/quantile.h"
#include "eval/metrics/for_each_pixel.h"

namespace saccade::eval {

Rgb8 divergingColor(float v, float scale) {
  const float s = std::clamp(v / scale, -1.f, 1.f), rest = 255 * (1 - std::abs(s));
  const auto fade = static_cast<unsigned char>(rest);
  return s > 0 ? Rgb8{255, fade, fade} : Rgb8{fade, fade, 255};
}

float colorScale(const ImageF& plane) {
  std::vector<float> values;
  forEachPixel(plane, [&](int x, int y) { values.push_back(std::abs(plane.at(x, y))); });
  return std::max(quantile(values, 0.97), 1e-9f);
}

std::vector<Rgb8> signedPicture(const ImageF& plane, float scale) {
  std::vector<Rgb8> pixels;
  forEachPixel(plane, [&](int x, int y) { pixels.push_back(divergingColor(plane.at(x, y), scale)); });
  return pixels;
}

std::vector<Rgb8> differencePicture(const ImageF& x, const ImageF& ref) {
  checkSameSize(x, ref);
  const int w = ref.width(), h = ref.height();
  const float scale = colorScale(ref);
  std::vector<Rgb8> pixels;
  pixels.reserve(static_cast<std::size_t>(3 * w) * h);
  for (int row = 0; row < h; ++row) {
    for (int column = 0; column < 3 * w; ++column) {
      const int c = column % w;
      const float v[3] = {x.at(c, row), ref.at(c, row), x.at(c, row) - ref.at(c, row)};
      pixels.push_back(divergingColor(v[column / w], scale));
    }
  }
  return pixels;
}

}  // namespace saccade::eval
