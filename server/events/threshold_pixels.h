// Pixels with two thresholds, a refractory period and a bound of events: the common part of all event models.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "events/event_model.h"
#include "events/pixel_thresholds.h"

namespace saccade {

// Moves pixels through one interval after the other.
//
// A pixel's level v is its log brightness minus its reference. An ON event comes where v reaches C+, an OFF
// event where it reaches -C-; the reference then moves there, so that v is 0. Log brightness is linear inside
// the interval.
//
// After an event the pixel is blind for the refractory period, and then takes the level it sees as its
// reference (v = 0). Thresholds passed meanwhile count as suppressed: the whole ones of the net change.
//
// Events beyond the bound of a pixel, or of all pixels in the order in which they are moved, count as
// suppressed. The pixel behaves as if they had been sent.
//
// `Thresholds` is EqualThresholds or OwnThresholds.
template <class Thresholds>
class ThresholdPixels {
 public:
  ThresholdPixels(const SensorConfig& config, int width, int height);

  // The level of pixel (x, y) at a fraction [0, 1) of the way from -C- to C+.
  float levelAt(int x, int y, double fraction) const;
  // The threshold in the direction of `change`, C+ or C-.
  double threshold(int x, int y, double change) const {
    return change > 0 ? thresholds_.on(x, y) : thresholds_.off(x, y);
  }

  void begin(const Interval& interval);
  void setThresholds(const SensorConfig& config);  // those of another configuration

  // Moves pixel (x, y) from level `v` in (-C-, C+) by `change` != 0 over the interval, and appends its
  // events. Returns the level at t1, in (-C-, C+). A blind pixel ignores v; while it is blind the result
  // means nothing.
  float advance(int x, int y, double v, double change, Events& events) {
    const double moved = v + change;
    const bool between = moved > -thresholds_.off(x, y) && moved < thresholds_.on(x, y);
    const bool quiet = between && blindness_.empty();  // the most frequent case
    return quiet ? inside(x, y, moved) : advanceInFull(x, y, v, change, events);
  }

  // The same for the pixels of row y whose change is not 0, by their levels `v`. Both rows may be read beyond
  // the width, up to a multiple of 16, where there is no change.
  void advanceRow(int y, const float* dL, float* v, Events& events);

  // The same for the first interval after setThresholds(). A level outside first makes an event at t0, and
  // becomes 0.
  void settleRow(int y, const float* dL, float* v, Events& events);

  std::uint64_t suppressed() const { return suppressed_; }  // since begin()

 private:
  struct Blindness {
    TimeNs until = kAwake;
    double change = 0;  // of log brightness, since the event
  };
  static constexpr TimeNs kAwake = TimeNs::min();

  // Evenly spaced crossings of one pixel in one interval.
  struct Crossings {
    double start;          // fraction of the interval at which the pixel is awake
    double first, period;  // log brightness from there to the first crossing, and from one to the next
    double speed;          // log brightness per interval

    double distance(std::int64_t k) const { return first + static_cast<double>(k) * period; }
    double fraction(std::int64_t k) const { return start + distance(k) / speed; }
  };

  float advanceInFull(int x, int y, double v, double change, Events& events);
  bool wakes(Blindness& blindness, int x, int y, double change, double& start);
  float settle(int x, int y, float v, Events& events);
  // Of the pixel; nullptr without refractory period.
  Blindness* blindnessOf(int x, int y) {
    return blindness_.empty() ? nullptr : &blindness_[static_cast<std::size_t>(y) * width_ + x];
  }
  void send(const Crossings& crossings, std::int64_t count, Event event, Events& events);
  // Rounding to float must not put a level on a threshold.
  float inside(int x, int y, double v) const {
    return std::clamp(static_cast<float>(v), thresholds_.lowest(x, y), thresholds_.highest(x, y));
  }

  Thresholds thresholds_;
  TimeNs refractory_;
  std::int64_t max_events_;       // of a pixel
  std::int64_t settled_ = 0;      // of these, made already by the pixel that is being moved
  std::uint64_t max_all_, room_;  // of all pixels; how many more of them this interval
  int width_, height_;
  std::vector<Blindness> blindness_;  // by pixel; empty without refractory period
  Interval interval_{};
  double length_ns_ = 0;
  std::uint64_t suppressed_ = 0;
};

}  // namespace saccade
