// The newest interval of a feed, for get_frame. It is copied only when somebody asks for it.
#pragma once

#include <memory>
#include <mutex>

#include "frame/intensity_change.h"

namespace saccade {

// All members may be called from any thread.
class NewestInterval {
 public:
  // `change` must stay as it is until the next call has returned. That call waits for no more than one copy.
  // `frame`: the first of the stream at t1 or later; the copy has it.
  void set(const IntensityChange& change, FrameIndex frame);
  std::unique_ptr<const IntensityChange> copy() const;  // nullptr before the first set()

 private:
  mutable std::mutex mutex_;
  const IntensityChange* newest_ = nullptr;
  FrameIndex frame_ = 0;
};

}  // namespace saccade
