#include "feed/rig.h"

namespace saccade {

void Rig::steer(const TimedPose& key) {
  for (const auto& feed : feeds_) feed->steer(key);
}

const std::vector<FeedInterval>& Rig::step(const PoolHandle& pool) {
  intervals_.clear();
  for (const auto& feed : feeds_) {
    feed->step(pool);
    intervals_.push_back(feed->interval());
  }
  return intervals_;
}

StageTimes Rig::lastTimes() const {
  StageTimes sum;
  for (const auto& feed : feeds_) sum += feed->lastTimes();
  return sum;
}

std::chrono::nanoseconds Rig::lastChain() const {
  std::chrono::nanoseconds sum{0};
  for (const auto& feed : feeds_) sum += feed->lastChain();
  return sum;
}

}  // namespace saccade
