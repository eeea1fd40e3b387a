#include "feed/rig.h"

#include <algorithm>

namespace saccade {

void Rig::steer(const FeedKeys& keys) {
  for (const auto& feed : feeds_) feed->steer(keys);
}

const std::vector<FeedInterval>& Rig::step(const PoolHandle& pool) {
  intervals_.clear();
  for (const auto& feed : feeds_) {
    feed->step(pool);
    intervals_.push_back(feed->interval());
  }
  return intervals_;
}

PixelSpeed Rig::pixelSpeed(FrameIndex frames) const {
  PixelSpeed most;
  for (const auto& feed : feeds_) {
    const PixelSpeed speed = feed->pixelSpeed(frames);
    most = {std::max(most.p50, speed.p50), std::max(most.p99, speed.p99)};
  }
  return most;
}

StageTimes Rig::lastTimes() const {
  StageTimes sum;
  for (const auto& feed : feeds_) sum += feed->lastTimes();
  return sum;
}

std::chrono::nanoseconds Rig::lastCriticalPath() const {
  std::chrono::nanoseconds sum{0};
  for (const auto& feed : feeds_) sum += feed->lastCriticalPath();
  return sum;
}

}  // namespace saccade
