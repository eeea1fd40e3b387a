// Draws one moment of a stream: brightness, its change, and the latest events.
#pragma once

#include <cstdint>
#include <span>

#include "client/drawing/rgb_picture.h"
#include "saccade/v1/control.pb.h"
#include "saccade/wire/event.h"

namespace saccade::client {

// Three panels side by side, each with its caption. The first is intensity, exposed to its 99th percentile,
// with gamma 2.2. The second is the change of log brightness, from blue (negative) over white (0) to red. The
// third is `events` of the window_ns before the frame, ON red and OFF blue on white. The latest event of a
// pixel is on top. Throws std::runtime_error if the planes do not have the frame's size.
RgbPicture drawPreview(const v1::FramePicture& frame, std::span<const Event> events, std::int64_t window_ns);

}  // namespace saccade::client
