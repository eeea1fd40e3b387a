// Pixels with two thresholds, a refractory period and a bound of events: the common part of all event models.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "events/event_bounds.h"
#include "events/event_model.h"
#include "events/pixel_thresholds.h"

namespace saccade {

// Moves pixels through one interval after the other.
//
// A pixel's level v is its log brightness minus its reference. An ON event comes where v reaches C+, an OFF
// event where it reaches -C-; the reference then moves there, so that v is 0. Log brightness is linear inside
// the interval, or inside each of its parts.
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

  // `once`: no pixel is moved or settled more than once in this interval.
  void begin(const Interval& interval, bool once);
  void setThresholds(const SensorConfig& config);  // those of another configuration

  // A part of the interval, as shares of it.
  struct Part {
    double from = 0, to = 1;
  };

  // Moves pixel (x, y) from level `v` in (-C-, C+) by `change` != 0 over a part of the interval, and appends
  // its events. Returns the level at its end, in (-C-, C+). A blind pixel ignores v; while it is blind the
  // result means nothing.
  float advance(int x, int y, double v, double change, Part part, Events& events) {
    const double moved = v + change;
    const bool between = moved > -thresholds_.off(x, y) && moved < thresholds_.on(x, y);
    const bool quiet = between && blindness_.empty();  // the most frequent case
    return quiet ? inside(x, y, moved) : advanceInFull(x, y, v, change, part, events);
  }

  // The same for the pixels of row y whose change is not 0, by their levels `v`. Both rows may be read beyond
  // the width, up to a multiple of 16, where there is no change. `from`: where the part that ends at t1
  // begins, of each pixel; nullptr: at t0.
  void advanceRow(int y, const float* dL, const float* from, float* v, Events& events);

  // In the first interval after setThresholds(), before the pixel moves: a level outside makes an event at
  // t0, and becomes 0. Returns the level.
  float settle(int x, int y, float v, Events& events);

  std::uint64_t suppressed() const { return bounds_.suppressed(); }  // since begin()

 private:
  struct Blindness {
    TimeNs until = kAwake;
    double change = 0;  // of log brightness, since the event
  };
  static constexpr TimeNs kAwake = TimeNs::min();

  // Evenly spaced crossings of one pixel in one part of the interval.
  struct Crossings {
    Part part;
    double start;          // fraction of the part at which the pixel is awake
    double first, period;  // log brightness from there to the first crossing, and from one to the next
    double speed;          // log brightness per part

    double distance(std::int64_t k) const { return first + static_cast<double>(k) * period; }
    double fraction(std::int64_t k) const { return start + distance(k) / speed; }
  };

  float advanceInFull(int x, int y, double v, double change, Part part, Events& events);
  bool wakes(Blindness& blindness, int x, int y, double change, Part part, double& start);
  std::size_t indexOf(int x, int y) const { return static_cast<std::size_t>(y) * width_ + x; }
  // Of the pixel; nullptr without refractory period.
  Blindness* blindnessOf(int x, int y) { return blindness_.empty() ? nullptr : &blindness_[indexOf(x, y)]; }
  void send(const Crossings& crossings, std::int64_t count, Event event, Events& events);
  // Rounding to float must not put a level on a threshold.
  float inside(int x, int y, double v) const {
    return std::clamp(static_cast<float>(v), thresholds_.lowest(x, y), thresholds_.highest(x, y));
  }

  Thresholds thresholds_;
  TimeNs refractory_;
  EventBounds bounds_;
  int width_, height_;
  std::vector<Blindness> blindness_;  // by pixel; empty without refractory period
  Interval interval_{};
  double length_ns_ = 0;
};

}  // namespace saccade
