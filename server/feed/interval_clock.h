// The times of a rig's intervals: whole frames, or parts of them that follow motion.
#pragma once

#include <span>

#include "base/units.h"
#include "feed/interval_bounds.h"

namespace saccade {

class IntervalClock {
 public:
  // The times at which motion is measured divide what is left of a frame into so many equal steps.
  static constexpr int kSteps = 16;

  IntervalClock(double frame_rate_hz, const IntervalBounds& bounds)
      : frame_rate_hz_(frame_rate_hz), bounds_(bounds) {}

  const IntervalBounds& bounds() const { return bounds_; }
  TimeNs now() const { return now_; }
  FrameIndex frame() const { return frame_; }  // the first frame at now() or later
  bool atFrame() const { return now_ == frameTime(frame_, frame_rate_hz_); }
  TimeNs frameEnd() const { return frameTime(frame_ + (atFrame() ? 1 : 0), frame_rate_hz_); }

  // Ends the interval that begins now, and returns its end: frameEnd(), or where bounds() say so, an earlier
  // time. `steps`: how far the picture moves in each step from now to frameEnd(), px; none: not at all.
  TimeNs advance(std::span<const double> steps);

 private:
  TimeNs endOf(std::span<const double> steps) const;

  double frame_rate_hz_;
  IntervalBounds bounds_;
  TimeNs now_{0};
  FrameIndex frame_ = 0;
};

}  // namespace saccade
