// Refined intervals against frames: CPU time and events.
#pragma once

#include <memory>

#include "eval/metrics/window_errors.h"
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
  // `look_ups_s`: of all fine frames without a filter.
  double refined_s = 0, fine_s = 0, look_ups_s = 0, halves_s = 0;
  double samples = 0, unsplit = 0, rays = 0;  // see RefinementCounts, sums
  double events = 0;                          // of the truth, which looks up all pixels at all fine times
  // Against it, in windows of an interval. `look_up_errors`: of fine frames without a filter; `half_errors`:
  // of every half interval of the truth.
  WindowErrors refined_errors, look_up_errors, half_errors;
};

// All feeds take turns on one thread. Throws Interrupted.
RefineResult measureRefinement(const RefineSetup& setup);

}  // namespace saccade::eval
