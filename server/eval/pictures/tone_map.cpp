#include "eval/pictures/tone_map.h"

#include <algorithm>
#include <cmath>

#include "base/quantile.h"
#include "eval/metrics/for_each_pixel.h"

namespace saccade::eval {

unsigned char encodeSrgb(float linear) {
  const float v = std::clamp(linear, 0.f, 1.f);
  const float encoded = v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
  return static_cast<unsigned char>(255 * encoded + 0.5f);
}

float exposureOf(const ImageF& luminance) {
  std::vector<float> values;
  forEachPixel(luminance, [&](int x, int y) {
    const float v = luminance.at(x, y);
    values.push_back(std::isfinite(v) ? v : 0);
  });
  return 0.8f / std::max(quantile(values, 0.9), 1e-9f);
}

GridPicture greyPicture(const ImageF& luminance, float exposure) {
  GridPicture picture{"", luminance.width(), luminance.height(), {}};
  forEachPixel(luminance, [&](int x, int y) {
    const unsigned char v = encodeSrgb(luminance.at(x, y) * exposure);
    picture.pixels.push_back({v, v, v});
  });
  return picture;
}

}  // namespace saccade::eval
