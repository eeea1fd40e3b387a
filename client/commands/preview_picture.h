// Draws one moment of a stream: brightness, its change, and the events that led there.
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

inline constexpr int kPanelGap = 4;  // white columns between the panels

// Three panels of the frame's size side by side: intensity, exposed to its 99th percentile, with gamma; the
// change of log brightness, blue below and red above 0, white at 0; `events`, ON red and OFF blue on white,
// the latest of a pixel on top. Throws std::runtime_error where the planes do not fit the frame's size.
RgbPicture drawPreview(const v1::FramePicture& frame, std::span<const Event> events);

}  // namespace saccade::client
