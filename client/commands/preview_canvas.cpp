#include "client/commands/preview_canvas.h"

#include "client/drawing/pixel_font.h"

namespace saccade::client {
namespace {

constexpr int kLineHeight = kGlyphHeight + 4, kMargin = 2;

}  // namespace

PreviewLayout::PreviewLayout(int frame_width)
    : zoom((kMinPanelWidth + frame_width - 1) / frame_width), panel_width(zoom * frame_width) {}

PreviewCanvas::PreviewCanvas(int frame_width, int frame_height) : layout_(frame_width) {
  picture_ = whitePicture(layout_.left(2) + layout_.panel_width,
                          PreviewLayout::kCaptionHeight + frame_height * layout_.zoom);
}

void PreviewCanvas::set(int panel, int x, int y, Colour colour) {
  const int left = layout_.left(panel) + x * layout_.zoom;
  const int top = PreviewLayout::kCaptionHeight + y * layout_.zoom;
  for (int v = 0; v < layout_.zoom; ++v)
    for (int u = 0; u < layout_.zoom; ++u) picture_.put(left + u, top + v, colour);
}

int PreviewCanvas::write(int panel, int line, int column, const std::string& text, Colour colour) {
  const int left = layout_.left(panel) + kMargin;
  return (picture_.write(left + column * kLetterWidth, kMargin + line * kLineHeight, text, colour) - left) /
         kLetterWidth;
}

}  // namespace saccade::client
