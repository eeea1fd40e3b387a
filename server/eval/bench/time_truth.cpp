#include "eval/bench/time_truth.h"

#include "eval/bench/interrupt.h"
#include "events/sensor.h"
#include "feed/rig.h"

namespace saccade::eval {

TimeTruth::TimeTruth(const TimeTruthSetup& setup, TilePool& pool)
    : setup_(setup), pool_(pool), reference_(run(framesOf(setup.fine), truth_)) {}

TimeTruthRow TimeTruth::measureFrames(double per_window) {
  return measure(framesOf(per_window), truth_);
}

TimeTruthRow TimeTruth::measureIntervals(const IntervalBounds& bounds, bool refined) {
  FeedConfig feed = setup_.feed;
  feed.intervals = bounds;
  if (!refined) return measure(feed, truth_);
  feed.refinement = {
      .finest_px = bounds.px / 16, .threshold = setup_.sensor.threshold, .bias = setup_.sensor.bias};
  return measure(feed, unfilteredTruth(*feed.refinement));
}

const Events& TimeTruth::unfilteredTruth(const RefinementSettings& refinement) {
  if (!unfiltered_) {
    FeedConfig feed = framesOf(setup_.fine);
    feed.refinement = refinement;  // too coarse for these frames, so that none is divided
    run(feed, unfiltered_.emplace());
  }
  return *unfiltered_;
}

FeedConfig TimeTruth::framesOf(double per_window) const {
  FeedConfig feed = setup_.feed;
  feed.frame_rate_hz *= per_window;
  return feed;
}

TimeTruthRow TimeTruth::measure(const FeedConfig& feed, const Events& truth) const {
  Events events;
  TimeTruthRow row = run(feed, events);
  row.errors = windowErrors(events, truth, 1e9 / setup_.feed.frame_rate_hz);
  return row;
}

TimeTruthRow TimeTruth::run(const FeedConfig& feed, Events& events) const {
  Rig rig(std::make_unique<Feed>(setup_.scene, setup_.path, feed, pool_));
  Sensor sensor(setup_.sensor, feed.camera.width, feed.camera.height);
  SensorOutput out;
  TimeTruthRow row;
  const TimeNs end = frameTime(static_cast<FrameIndex>(setup_.windows), setup_.feed.frame_rate_hz);
  for (TimeNs t{0}; t < end;) {
    const IntensityChange& change = rig.step({pool_}).front().change;
    sensor.generate(change, out);
    events.insert(events.end(), out.events.begin(), out.events.end());
    row.cpu_ms += 1e3 * seconds(rig.lastTimes().total()) / setup_.windows;
    row.intervals += 1.0 / setup_.windows;
    t = change.t1;
    if (interrupted()) throw Interrupted{};
  }
  row.events = static_cast<double>(events.size()) / setup_.windows;
  return row;
}

}  // namespace saccade::eval
