// Three panels side by side, with a caption of two lines above each.
#pragma once

#include <string>
#include <utility>

#include "client/drawing/rgb_picture.h"

namespace saccade::client {

// Where the three panels stand, in pixels of the picture.
struct PreviewLayout {
  static constexpr int kGap = 8;              // white columns between panels
  static constexpr int kCaptionHeight = 24;   // two lines of words above each panel
  static constexpr int kMinPanelWidth = 240;  // so that the words fit
  explicit PreviewLayout(int frame_width);
  int left(int panel) const { return panel * (panel_width + kGap); }
  int zoom;         // pixels of the picture per pixel of the frame, along each axis
  int panel_width;  // at least kMinPanelWidth
};

class PreviewCanvas {
 public:
  PreviewCanvas(int frame_width, int frame_height);  // white

  // Colours the pixel x, y of the frame in a panel (0 to 2 from the left).
  void set(int panel, int x, int y, Colour colour);
  // Writes into line 0 or 1 of a panel's caption, from `column` letters on. Returns the column after the
  // text.
  int write(int panel, int line, int column, const std::string& text, Colour colour);
  RgbPicture take() { return std::move(picture_); }

 private:
  PreviewLayout layout_;
  RgbPicture picture_;
};

}  // namespace saccade::client
