// Compares two files of events, window by window.
#pragma once

#include <cstdint>

#include "eval/files/event_windows.h"
#include "eval/metrics/stream_distance.h"
#include "eval/metrics/stream_summary.h"

namespace saccade::eval {

struct FileComparison {
  explicit FileComparison(const client::ImageSize& size)
      : distance(static_cast<int>(size.width), static_cast<int>(size.height)) {}

  StreamSummary of_a, of_b;
  StreamDistance distance;
};

// Reads both to their ends. Windows begin at multiples of `window_ns` > 0. Throws std::invalid_argument where
// the images have different sizes, and as EventWindows::until().
FileComparison compareFiles(EventWindows& a, EventWindows& b, std::int64_t window_ns);

}  // namespace saccade::eval
