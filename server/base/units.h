// Time and frame numbers, with the unit in the type.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>

namespace saccade {

using TimeNs = std::chrono::nanoseconds;  // stream time, 0 at the first frame
using FrameIndex = std::uint64_t;

inline constexpr TimeNs kEventTimeUnit{1000};  // events are stamped in whole microseconds

// The time of frame `t` at `rate_hz`. It is rounded to the event time unit, so that packets tile time
// exactly.
inline TimeNs frameTime(FrameIndex t, double rate_hz) {
  return std::llround(static_cast<double>(t) * 1e9 / rate_hz / kEventTimeUnit.count()) * kEventTimeUnit;
}

inline double seconds(TimeNs t) {
  return std::chrono::duration<double>(t).count();
}

}  // namespace saccade
