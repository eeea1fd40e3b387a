#include "app/feeds/newest_interval.h"

namespace saccade {

void NewestInterval::set(const IntensityChange& change, FrameIndex frame) {
  std::lock_guard lock(mutex_);
  newest_ = &change;
  frame_ = frame;
}

std::unique_ptr<const IntensityChange> NewestInterval::copy() const {
  std::lock_guard lock(mutex_);
  if (!newest_) return nullptr;
  auto copy = std::make_unique<IntensityChange>(newest_->dI.width(), newest_->dI.height());
  copy->copyFrom(*newest_);
  copy->frame = frame_;
  return copy;
}

}  // namespace saccade
