// The times on the wall clock at which the frames of a feed are due.
#pragma once

#include "base/units.h"
#include "stream/change_notifier.h"

namespace saccade {

class PaceClock {
 public:
  using Clock = ChangeNotifier::Clock;

  // `speed`: stream seconds per second; 0: frames are never due.
  explicit PaceClock(double speed) : speed_(speed) {}

  // Call this before each frame. A clock that stands still starts at the stream time `now`. With `keeps`
  // false it stands still again, because this frame need not keep the pace.
  void begin(TimeNs now, bool keeps) {
    if (!keeps_ && speed_ > 0) zero_ = Clock::now() - wallTime(now);
    keeps_ = keeps;
  }
  void hold() { keeps_ = false; }

  bool running() const { return keeps_ && speed_ > 0; }
  Clock::time_point due(TimeNs t) const { return zero_ + wallTime(t); }  // while it runs

 private:
  Clock::duration wallTime(TimeNs t) const {
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds(t) / speed_));
  }

  double speed_;
  bool keeps_ = false;
  Clock::time_point zero_;  // when stream time 0 was due
};

}  // namespace saccade
