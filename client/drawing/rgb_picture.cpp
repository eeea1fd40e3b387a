#include "client/drawing/rgb_picture.h"

#include <algorithm>
#include <cmath>

#include "client/drawing/pixel_font.h"
#include "pictures/library.h"

namespace saccade::client {

static_assert(kLetterWidth == kGlyphWidth + 1);

Colour mix(Colour from, Colour to, float weight) {
  for (std::size_t i = 0; i < from.size(); ++i) from[i] += weight * (to[i] - from[i]);
  return from;
}

void RgbPicture::put(int x, int y, Colour colour) {
  if (x >= width || y >= height) return;
  const std::size_t at = 3 * (std::size_t(y) * width + x);
  for (std::size_t i = 0; i < colour.size(); ++i) {
    const float value = std::clamp(colour[i], 0.0f, 1.0f);
    pixels[at + i] = static_cast<std::uint8_t>(std::lround(value * 255));
  }
}

int RgbPicture::write(int x, int y, const std::string& text, Colour colour) {
  for (const char character : text) {
    for (int v = 0; v < kGlyphHeight; ++v)
      for (int u = 0; u < kGlyphWidth; ++u)
        if (isInk(character, u, v)) put(x + u, y + v, colour);
    x += kLetterWidth;
  }
  return x;
}

RgbPicture whitePicture(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(std::size_t{3} * width * height, 255)};
}

void writePng(const std::string& path, const RgbPicture& picture) {
  const pictures::Shape shape{picture.width, picture.height, {"R", "G", "B"}, pictures::Number::kU8};
  pictures::library().write(path, shape, picture.pixels.data());
}

}  // namespace saccade::client
