#include "eval/bench/refine_bench.h"

#include "eval/bench/interrupt.h"
#include "events/sensor.h"

namespace saccade::eval {
namespace {

// Sensors without reconstruction or noise, and all of their events.
class AllEvents {
 public:
  explicit AllEvents(const FeedConfig& feed)
      : sensor_({.threshold = feed.refinement->threshold,
                 .threshold_off = feed.refinement->threshold,
                 .bias = feed.refinement->bias,
                 .reconstruction = "direct"},
                feed.camera.width, feed.camera.height) {}

  void take(const IntensityChange& change) {
    sensor_.generate(change, out_);
    events_.insert(events_.end(), out_.events.begin(), out_.events.end());
  }
  const Events& events() const { return events_; }

 private:
  Sensor sensor_;
  SensorOutput out_;
  Events events_;
};

// A feed, its CPU time and its events.
struct Measured {
  Feed feed;
  AllEvents all;
  double cpu_s = 0;

  const IntensityChange& step(TilePool& pool) {
    const IntensityChange& change = feed.step(pool);
    cpu_s += seconds(feed.lastTimes().total());
    all.take(change);
    return change;
  }
};

RefinementSettings everywhere(RefinementSettings settings) {
  settings.threshold = 1e-9, settings.most_updates = 1e9, settings.every_ray = true;
  return settings;
}

// Its frames are those of refinement.
RefinementSettings never(RefinementSettings settings) {
  settings.finest_px = 1e9;
  return settings;
}

class RefineBench {
 public:
  explicit RefineBench(const RefineSetup& s)
      : setup_(s),
        refined_(make(1, s.config.refinement)),
        truth_(make(1, everywhere(*s.config.refinement))),
        fine_(make(s.pieces, {})),
        look_ups_(make(s.pieces, never(*s.config.refinement))),
        halves_(make(2, {})),
        half_change_(s.config.camera.width, s.config.camera.height),
        half_events_(s.config) {}

  RefineResult run() {
    RefineResult result;
    for (int interval = 0; interval < setup_.intervals; ++interval) {
      takeHalves(truth_.step(pool_));
      for (int k = 0; k < setup_.pieces; ++k) fine_.step(pool_), look_ups_.step(pool_);
      halves_.step(pool_), halves_.step(pool_);
      refined_.step(pool_);
      result.samples += static_cast<double>(refined_.feed.refined().samples);
      result.unsplit += static_cast<double>(refined_.feed.refined().unsplit);
      result.rays += static_cast<double>(refined_.feed.refined().rays);
      if (interrupted()) throw Interrupted{};
    }
    const Events& truth = truth_.all.events();
    const double window_ns = 1e9 / setup_.config.frame_rate_hz;
    result.events = static_cast<double>(truth.size());
    result.refined_errors = windowErrors(refined_.all.events(), truth, window_ns);
    result.look_up_errors = windowErrors(look_ups_.all.events(), truth, window_ns);
    result.half_errors = windowErrors(half_events_.events(), truth, window_ns);
    result.refined_s = refined_.cpu_s, result.fine_s = fine_.cpu_s;
    result.look_ups_s = look_ups_.cpu_s, result.halves_s = halves_.cpu_s;
    return result;
  }

 private:
  Measured make(int frames, const std::optional<RefinementSettings>& refinement) {
    FeedConfig config = setup_.config;
    config.frame_rate_hz *= frames, config.refinement = refinement;
    return {Feed(setup_.scene, setup_.path, config, {pool_}), AllEvents(setup_.config)};
  }

  // Frames at half an interval have the brightness of the truth, so that the filter does not count.
  void takeHalves(const IntensityChange& truth) {
    half_change_.copyFrom(truth);
    std::erase_if(half_change_.updates, [](const IntensityUpdate& u) { return u.at != 0.5f; });
    half_events_.take(half_change_);
  }

  const RefineSetup& setup_;
  TilePool pool_{1};
  Measured refined_, truth_, fine_, look_ups_, halves_;
  IntensityChange half_change_;
  AllEvents half_events_;
};

}  // namespace

RefineResult measureRefinement(const RefineSetup& setup) {
  return RefineBench(setup).run();
}

}  // namespace saccade::eval
