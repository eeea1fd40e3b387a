#include "feed/rig.h"

#include <algorithm>

namespace saccade {
namespace {

constexpr double kLampRate =
    1000;  // least intervals per second where the strengths of lamps change over time

}  // namespace

void Rig::steer(const FeedKeys& keys) {
  for (const auto& feed : feeds_) feed->steer(keys);
}

// All views share the intervals.
const std::vector<FeedInterval>& Rig::step(const PoolHandle& pool) {
  const bool follows = clock_.bounds().followMotion(), begun = clock_.now() > TimeNs{0};
  if (follows) measureMotion();
  const TimeNs t1 = clock_.advance(motion_);
  const bool stands = follows && begun && standsUntil(t1);
  intervals_.clear();
  for (const auto& feed : feeds_) {
    if (stands) {
      feed->holdTo(t1);
    } else {
      feed->stepTo(t1, pool);
    }
    intervals_.push_back(feed->interval());
    intervals_.back().frame = clock_.frame(), intervals_.back().ends_frame = clock_.atFrame();
  }
  return intervals_;
}

// In each step the view counts in which the picture moves most.
void Rig::measureMotion() {
  std::array<TimeNs, IntervalClock::kSteps> times;
  for (int i = 0; i < IntervalClock::kSteps; ++i)
    times[i] = clock_.now() + (clock_.frameEnd() - clock_.now()) * (i + 1) / IntervalClock::kSteps;
  motion_.fill(0);
  std::array<double, IntervalClock::kSteps> px;
  for (const auto& feed : feeds_) {
    feed->measureMotion(times, px);
    std::ranges::transform(motion_, px, motion_.begin(), [](double a, double b) { return std::max(a, b); });
  }
  if (!first().lampsChange()) return;
  const double most = clock_.bounds().px * kLampRate * seconds(times[0] - clock_.now());
  for (double& px : motion_) px = std::max(px, most);
}

bool Rig::standsUntil(TimeNs t) const {
  return std::ranges::all_of(motion_, [](double px) { return px == 0; }) &&
         std::ranges::all_of(feeds_, [&](const auto& feed) { return feed->standsUntil(t); });
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
