// The feeds of cameras that are fixed to one moving body, in step on one clock.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "feed/feed.h"
#include "feed/interval_clock.h"
#include "feed/interval_source.h"

namespace saccade {

class Rig : public IntervalSource {
 public:
  // `feeds`: at least one, one for each view, none of which has made a step; all of the same frame rate and
  // IntervalBounds.
  explicit Rig(std::vector<std::unique_ptr<Feed>> feeds)
      : feeds_(std::move(feeds)), clock_(first().config().frame_rate_hz, first().config().intervals) {}
  explicit Rig(std::unique_ptr<Feed> feed) : Rig(listOf(std::move(feed))) {}

  // Adds keys to the paths of each view, after the last ones.
  void steer(const FeedKeys& keys);

  bool atFrame() const { return clock_.atFrame(); }  // whether the next step begins a frame
  const std::vector<FeedInterval>& step(const PoolHandle& pool) override;

  const Feed& first() const { return *feeds_.front(); }
  // Of the view in which it is largest, as Feed::pixelSpeed().
  PixelSpeed pixelSpeed(FrameIndex frames) const;
  StageTimes lastTimes() const override;
  std::chrono::nanoseconds lastCriticalPath() const override;  // the views are rendered one after the other

 private:
  static std::vector<std::unique_ptr<Feed>> listOf(std::unique_ptr<Feed> feed) {
    std::vector<std::unique_ptr<Feed>> list;
    list.push_back(std::move(feed));
    return list;
  }
  void measureMotion();
  bool standsUntil(TimeNs t) const;

  std::vector<std::unique_ptr<Feed>> feeds_;
  IntervalClock clock_;
  std::array<double, IntervalClock::kSteps> motion_{};  // of the interval that begins, see advance()
  std::vector<FeedInterval> intervals_;
};

}  // namespace saccade
