// The feeds of cameras that are fixed to one moving body, in step on one clock.
#pragma once

#include <memory>
#include <vector>

#include "feed/feed.h"
#include "feed/interval_source.h"

namespace saccade {

class Rig : public IntervalSource {
 public:
  // `feeds`: at least one, one for each view, none of which has made a step; all of the same frame rate.
  explicit Rig(std::vector<std::unique_ptr<Feed>> feeds) : feeds_(std::move(feeds)) {}
  explicit Rig(std::unique_ptr<Feed> feed) { feeds_.push_back(std::move(feed)); }

  // Adds keys to the paths of each view, after the last ones.
  void steer(const FeedKeys& keys);

  const std::vector<FeedInterval>& step(const PoolHandle& pool) override;

  const Feed& first() const { return *feeds_.front(); }
  // Of the view in which it is largest, as Feed::pixelSpeed().
  PixelSpeed pixelSpeed(FrameIndex frames) const;
  StageTimes lastTimes() const override;
  std::chrono::nanoseconds lastCriticalPath() const override;  // the views are rendered one after the other

 private:
  std::vector<std::unique_ptr<Feed>> feeds_;
  std::vector<FeedInterval> intervals_;
};

}  // namespace saccade
