#include "eval/pictures/signed_picture.h"

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

GridPicture signedPicture(const ImageF& plane, float scale, const std::string& caption) {
  GridPicture picture{caption, plane.width(), plane.height(), {}};
  forEachPixel(plane, [&](int x, int y) { picture.pixels.push_back(divergingColor(plane.at(x, y), scale)); });
  return picture;
}

}  // namespace saccade::eval
