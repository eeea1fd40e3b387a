// Which frames a channel of pictures gives.
#pragma once

#include <cstddef>
#include <vector>

#include "base/units.h"

namespace saccade {

class FrameSelection {
 public:
  // Every n-th frame from frame 0 on, n >= 1.
  explicit FrameSelection(FrameIndex every = 1) : every_(every) {}
  // The first frames at or after these increasing times.
  explicit FrameSelection(std::vector<TimeNs> times) : times_(std::move(times)) {}

  // Whether the frame is wanted. Ask for all frames from some frame on, in order.
  bool takes(FrameIndex frame, TimeNs time) {
    if (times_.empty()) return frame % every_ == 0;
    const std::size_t before = next_;
    while (next_ < times_.size() && times_[next_] <= time) ++next_;
    return next_ > before;
  }

 private:
  FrameIndex every_ = 1;
  std::vector<TimeNs> times_;  // empty: `every_`
  std::size_t next_ = 0;       // the first time that is still to come
};

}  // namespace saccade
