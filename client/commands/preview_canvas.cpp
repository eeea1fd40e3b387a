#include "client/commands/preview_canvas.h"

#include <algorithm>
#include <cmath>

#include "client/commands/pixel_font.h"

namespace saccade::client {
namespace {

constexpr int kLetterWidth = kGlyphWidth + 1, kLineHeight = kGlyphHeight + 4, kMargin = 2;

}  // namespace

PreviewLayout::PreviewLayout(int frame_width)
    : zoom((kMinPanelWidth + frame_width - 1) / frame_width), panel_width(zoom * frame_width) {}

PreviewCanvas::PreviewCanvas(int frame_width, int frame_height) : layout_(frame_width) {
  picture_.width = layout_.left(2) + layout_.panel_width;
  picture_.height = PreviewLayout::kCaptionHeight + frame_height * layout_.zoom;
  picture_.pixels.assign(std::size_t{3} * picture_.width * picture_.height, 255);
}

void PreviewCanvas::set(int panel, int x, int y, Colour colour) {
  const int left = layout_.left(panel) + x * layout_.zoom;
  const int top = PreviewLayout::kCaptionHeight + y * layout_.zoom;
  for (int v = 0; v < layout_.zoom; ++v)
    for (int u = 0; u < layout_.zoom; ++u) put(left + u, top + v, colour);
}

int PreviewCanvas::write(int panel, int line, int column, const std::string& text, Colour colour) {
  const int top = kMargin + line * kLineHeight;
  for (const char character : text) {
    const int left = layout_.left(panel) + kMargin + column++ * kLetterWidth;
    for (int y = 0; y < kGlyphHeight; ++y)
      for (int x = 0; x < kGlyphWidth; ++x)
        if (isInk(character, x, y)) put(left + x, top + y, colour);
  }
  return column;
}

void PreviewCanvas::put(int x, int y, Colour colour) {
  if (x >= picture_.width) return;
  const std::size_t at = 3 * (std::size_t(y) * picture_.width + x);
  for (int i = 0; i < 3; ++i) {
    const float value = std::clamp(colour[i], 0.0f, 1.0f);
    picture_.pixels[at + i] = static_cast<std::uint8_t>(std::lround(value * 255));
  }
}

}  // namespace saccade::client
