// Draws one moment of a stream: brightness, its change, and the latest events.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "saccade/v1/control.pb.h"
#include "wire/event.h"

namespace saccade::client {

struct RgbPicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;  // 3 bytes each, row by row from the top
};

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

// Three panels side by side, each with its caption: intensity, exposed to its 99th percentile, with
// gamma 2.2; the change of log brightness, from blue (negative) over white (0) to red; `events`, of the
// window_ns before the frame, ON red and OFF blue on white. The latest event of a pixel is on top. Throws
// std::runtime_error if the planes do not have the frame's size.
RgbPicture drawPreview(const v1::FramePicture& frame, std::span<const Event> events, std::int64_t window_ns);

}  // namespace saccade::client
