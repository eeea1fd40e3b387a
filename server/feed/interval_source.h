// Where the intervals of a stream come from: a rig of cameras in a scene, or frames that a client sends.
#pragma once

#include <chrono>
#include <vector>

#include "base/pool_handle.h"
#include "feed/feed_interval.h"
#include "methods/stage_times.h"

namespace saccade {

class IntervalSource {
 public:
  virtual ~IntervalSource() = default;

  // Whether step() has all that it needs. On the thread that calls step().
  virtual bool ready() const { return true; }
  // Makes the next interval of each view. The intervals hold until the next step, and their changes until the
  // second step after this one begins. Throws Cancelled.
  virtual const std::vector<FeedInterval>& step(const PoolHandle& pool) = 0;

  // Of the last step, all views together:
  virtual StageTimes lastTimes() const = 0;                       // CPU time
  virtual std::chrono::nanoseconds lastCriticalPath() const = 0;  // the least wall time
};

}  // namespace saccade
