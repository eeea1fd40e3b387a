// The events of a feed against those of the same feed with frames that are fine in time.
#pragma once

#include <memory>
#include <optional>

#include "eval/metrics/window_errors.h"
#include "events/sensor_config.h"
#include "feed/feed_config.h"
#include "render/world/render_scene.h"

namespace saccade::eval {

// A window is a frame of `feed`: a pixel of motion, where the path moves the picture by one in a frame.
struct TimeTruthSetup {
  std::shared_ptr<const RenderScene> scene;
  Trajectory path;
  FeedConfig feed;  // without intervals
  SensorConfig sensor;
  int windows = 4;
  int fine = 64;  // frames of the reference per window
};

struct TimeTruthRow {
  double cpu_ms = 0, intervals = 0, events = 0;  // per window; the first of the feed alone
  WindowErrors errors;
};

class TimeTruth {
 public:
  // Renders the reference. `setup` and `pool` outlive this. Throws Interrupted, as the others do.
  TimeTruth(const TimeTruthSetup& setup, TilePool& pool);

  const TimeTruthRow& reference() const { return reference_; }
  // With equal frames, so many per window.
  TimeTruthRow measureFrames(double per_window);
  // With intervals that follow motion, whose pixels are refined to a sixteenth of it or not. Refined ones
  // have no filter: they are compared with fine frames without it.
  TimeTruthRow measureIntervals(const IntervalBounds& bounds, bool refined);

 private:
  TimeTruthRow run(const FeedConfig& feed, Events& events) const;
  TimeTruthRow measure(const FeedConfig& feed, const Events& truth) const;
  const Events& unfilteredTruth(const RefinementSettings& refinement);
  FeedConfig framesOf(double per_window) const;

  const TimeTruthSetup& setup_;
  TilePool& pool_;
  Events truth_;
  std::optional<Events> unfiltered_;  // of fine frames of a refined feed, once they are asked for
  TimeTruthRow reference_;
};

}  // namespace saccade::eval
