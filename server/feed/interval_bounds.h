// The intervals of a feed, where they are shorter than its frames.
#pragma once

namespace saccade {

// A frame is divided into intervals. In each the surfaces move by at most about `px` pixels, but for one per
// cent of the pixels.
struct IntervalBounds {
  double px = 0;             // 0: each frame is one interval
  double max_rate_hz = 1e4;  // most intervals per second

  bool followMotion() const { return px > 0; }
};

}  // namespace saccade
