// Refined intervals against frames: CPU time, events, and brightness.
#pragma once

#include <memory>
#include <vector>

#include "eval/metrics/timed_events.h"
#include "feed/feed.h"

namespace saccade::eval {

struct RefineSetup {
  std::shared_ptr<const RenderScene> scene;
  const Trajectory& path;
  FeedConfig config;  // of the refined feed: its frames are the ends of intervals
  int intervals = 4;  // >= 1
  int pieces = 16;    // fine frames within each, an even number
};

struct RefineResult {
  // CPU seconds of the refined feed, of one with all fine frames, and of one with two frames to an interval.
  // `look_ups`: of all fine frames without a filter.
  double refined = 0, fine = 0, look_ups = 0, halves = 0;
  double samples = 0, unsplit = 0;  // see Refinement::Counts, sums
  double updates = 0;               // a pixel and fine frame
  // Against a feed that looks up all pixels at all fine times. `look_up_events`: of fine frames without a
  // filter; `halves_events`: of every half interval of the truth. Times are in fine frames.
  TimedScore refined_events, look_up_events, halves_events;
  double events = 0;  // true ones, a pixel and fine frame
  double off = 0, look_ups_off = 0,
         halves_off = 0;  // share of pixels and fine frames whose brightness is wrong by 0.1 thresholds
};

// All feeds take turns on one thread.
RefineResult measureRefinement(const RefineSetup& setup);

}  // namespace saccade::eval
