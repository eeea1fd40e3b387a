#include "eval/pictures/ratio_picture.h"

#include <algorithm>

#include "eval/metrics/for_each_pixel.h"
#include "eval/pictures/signed_picture.h"
#include "eval/pictures/text.h"
#include "eval/pictures/tone_map.h"

namespace saccade::eval {
namespace {

Rgb at(const RgbPlanes& planes, int x, int y) {
  return {planes[0].at(x, y), planes[1].at(x, y), planes[2].at(x, y)};
}

ImageF luminanceOf(const RgbPlanes& planes) {
  ImageF plane(planes[0].width(), planes[0].height());
  forEachPixel(plane, [&](int x, int y) { plane.at(x, y) = luminance(at(planes, x, y)); });
  return plane;
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
  const float exposure = exposureOf(luminanceOf(reference));
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
