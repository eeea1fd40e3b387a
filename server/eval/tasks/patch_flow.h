// The optical flow of patches of the picture, by the contrast of warped events.
#pragma once

#include <span>

#include "base/units.h"
#include "base/vec.h"
#include "eval/tasks/warped_events.h"

namespace saccade::eval {

inline constexpr int kPatchPx = 16;                   // the side of a patch
inline constexpr std::size_t kLeastPatchEvents = 30;  // a patch with less has no answer

// Pixels per second, of events of one patch, whose corner is `left`, `top`. Events are moved to where they
// would be at `reference`, and the variance of their image is largest [G18]. The search begins
// with no flow; it moves by about two pixels over `span_s`, the time of the events.
Vec2 patchFlow(std::span<const Event> events, int left, int top, TimeNs reference, double span_s);

}  // namespace saccade::eval
