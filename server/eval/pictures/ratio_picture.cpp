#include "eval/pictures/ratio_picture.h"

#include <algorithm>
#include <cmath>

#include "base/quantile.h"
#include "eval/metrics/for_each_pixel.h"
#include "eval/pictures/signed_picture.h"
#include "eval/pictures/text.h"

namespace saccade::eval {
namespace {

unsigned char encodeSrgb(float linear) {
  const float v = std::clamp(linear, 0.f, 1.f);
  const float encoded = v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
  return static_cast<unsigned char>(255 * encoded + 0.5f);
}

Rgb at(const RgbPlanes& planes, int x, int y) {
  return {planes[0].at(x, y), planes[1].at(x, y), planes[2].at(x, y)};
}

float exposureOf(const RgbPlanes& planes) {
  std::vector<float> luminances;
  forEachPixel(planes[0], [&](int x, int y) {
    const float v = luminance(at(planes, x, y));
    luminances.push_back(std::isfinite(v) ? v : 0);
  });
  return 0.8f / std::max(quantile(luminances, 0.9), 1e-9f);
}

Rgb8 encode(Rgb c) {
  return {encodeSrgb(c.x), encodeSrgb(c.y), encodeSrgb(c.z)};
}

Rgb8 ratioColor(const Block& block) {
  if (!block.compared) return {128, 128, 128};
  return divergingColor(static_cast<float>(block.ratio() - 1), kFullRatioColor);
}

}  // namespace

std::vector<GridPicture> ratioPictures(const RgbPlanes& picture, const RgbPlanes& reference,
                                       const BlockRatios& ratios) {
  const int w = reference[0].width(), h = reference[0].height(), pw = picture[0].width(),
            ph = picture[0].height();
  const float exposure = exposureOf(reference);
  GridPicture ours{"", w, h, {}}, theirs = ours, map = ours;
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      const int column = std::min(x / ratios.edge, ratios.across - 1),
                row = std::min(y / ratios.edge, ratios.down - 1);
      ours.pixels.push_back(encode(at(picture, x * pw / w, y * ph / h) * exposure));
      theirs.pixels.push_back(encode(at(reference, x, y) * exposure));
      map.pixels.push_back(ratioColor(ratios.blocks[static_cast<std::size_t>(row * ratios.across + column)]));
    }
  }
  map.caption = format("full colour: %.0f %%", 100 * kFullRatioColor);
  return {ours, theirs, map};
}

std::string drawRatios(const RgbPlanes& picture, const RgbPlanes& reference, const BlockRatios& ratios) {
  return drawPictureGrid({"picture", "reference", "ratio of blocks, grey is not compared"}, {""},
                         {ratioPictures(picture, reference, ratios)}, {"too dark", "equal", "too bright"});
}

}  // namespace saccade::eval
