#include "events/threshold_pixels.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/wide.h"

namespace saccade {
namespace {

std::uint64_t wholeThresholds(double change, double threshold) {
  return static_cast<std::uint64_t>(std::abs(change) / threshold);
}

}  // namespace

template <class Thresholds>
ThresholdPixels<Thresholds>::ThresholdPixels(const SensorConfig& config, int width, int height)
    : thresholds_(config, width, height),
      refractory_(config.refractory),
      bounds_(config, static_cast<std::size_t>(width) * height),
      width_(width),
      height_(height) {
  if (refractory_ > TimeNs(0)) blindness_.resize(static_cast<std::size_t>(width) * height);
}

template <class Thresholds>
float ThresholdPixels<Thresholds>::levelAt(int x, int y, double fraction) const {
  const double on = thresholds_.on(x, y), off = thresholds_.off(x, y);
  return inside(x, y, -off + fraction * (on + off));
}

template <class Thresholds>
void ThresholdPixels<Thresholds>::setThresholds(const SensorConfig& config) {
  thresholds_ = Thresholds(config, width_, height_);
}

template <class Thresholds>
void ThresholdPixels<Thresholds>::begin(const Interval& interval, bool once) {
  SACCADE_CHECK(interval.t0 < interval.t1);
  interval_ = interval;
  length_ns_ = static_cast<double>((interval.t1 - interval.t0).count());
  bounds_.begin(once);
}

// Whether a blind pixel wakes in this part, or woke before while its brightness did not change. `start`: the
// fraction of the part at which it wakes.
template <class Thresholds>
bool ThresholdPixels<Thresholds>::wakes(Blindness& blindness, int x, int y, double change, Part part,
                                        double& start) {
  const double asleep_ns =
      static_cast<double>((blindness.until - interval_.t0).count()) - part.from * length_ns_;
  start = std::max(0.0, asleep_ns / ((part.to - part.from) * length_ns_));
  if (start >= 1) {
    blindness.change += change;
    return false;
  }
  const double seen = blindness.change + start * change;
  bounds_.suppress(wholeThresholds(seen, threshold(x, y, seen)));
  blindness = {};
  return true;
}

template <class Thresholds>
void ThresholdPixels<Thresholds>::advanceRow(int y, const float* dL, const float* from, float* v,
                                             Events& events) {
  constexpr int kLanes = 8;
  using F = Floats<kLanes>;
  for (int x0 = 0; x0 < width_; x0 += kLanes) {
    const F change = load<kLanes>(dL + x0), level = load<kLanes>(v + x0), moved = level + change;
    const auto changes = change != 0.f;
    // Strictly between these bounds is between the thresholds, as advance() sees them.
    const auto quiet =
        changes && moved > thresholds_.lowBounds(x0, y) && moved < thresholds_.highBounds(x0, y);
    LaneSet loud = lanesOf(changes);
    if (blindness_.empty()) loud = loud - lanesOf(quiet);
    if (blindness_.empty()) store(select(quiet, moved, level), v + x0);
    forEachLane(loud, [&](int lane) {
      const int x = x0 + lane;
      v[x] = advance(x, y, v[x], dL[x], {from ? from[x] : 0.0, 1}, events);
    });
  }
}

template <class Thresholds>
float ThresholdPixels<Thresholds>::settle(int x, int y, float v, Events& events) {
  Blindness* blindness = blindnessOf(x, y);
  const bool between = v >= thresholds_.lowest(x, y) && v <= thresholds_.highest(x, y);
  if ((blindness && blindness->until != kAwake) || between) return v;
  if (bounds_.take(indexOf(x, y), 1) > 0)
    events.push_back(
        {interval_.t0.count(), static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), v > 0});
  if (blindness) *blindness = {interval_.t0 + refractory_, 0};
  return 0;
}

template <class Thresholds>
float ThresholdPixels<Thresholds>::advanceInFull(int x, int y, double v, double change, Part part,
                                                 Events& events) {
  // A blind pixel takes part from when it wakes.
  double start = 0;
  Blindness* blindness = blindnessOf(x, y);
  if (blindness && blindness->until != kAwake) {
    if (!wakes(*blindness, x, y, change, part, start)) return static_cast<float>(v);
    v = 0;
  }

  // Distances are measured along the direction of the change.
  const double sign = change > 0 ? 1 : -1, speed = std::abs(change);
  const double C = threshold(x, y, change);
  const double first = C - sign * v, rest = speed * (1 - start);
  if (rest < first) return inside(x, y, v + sign * rest);

  // From one event to the next brightness moves by C, and by what passes while the pixel is blind.
  const double part_ns = (part.to - part.from) * length_ns_;
  const double unseen = speed * static_cast<double>(refractory_.count()) / part_ns;
  const Crossings crossings{part, start, first, C + unseen, speed};
  const auto count = static_cast<std::int64_t>((rest - first) / crossings.period) + 1;
  send(crossings, count, {0, static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), change > 0},
       events);

  // At the end the pixel is still blind after its last event, or awake again.
  const double left = std::max(0.0, rest - crossings.distance(count - 1));
  const bool blind = blindness && left < unseen;
  bounds_.suppress(static_cast<std::uint64_t>(count - blind) * wholeThresholds(unseen, C));
  if (!blind) return inside(x, y, sign * (left - unseen));
  const auto event = TimeNs(std::llround(part.from * length_ns_ + crossings.fraction(count - 1) * part_ns));
  *blindness = {interval_.t0 + event + refractory_, sign * left};
  return 0;
}

// Appends the first crossings of `count` as events like `event`, as far as the bounds allow.
template <class Thresholds>
void ThresholdPixels<Thresholds>::send(const Crossings& crossings, std::int64_t count, Event event,
                                       Events& events) {
  const std::int64_t sent = bounds_.take(indexOf(event.x, event.y), count);
  const std::int64_t ticks = (interval_.t1 - interval_.t0) / kEventTimeUnit;
  const auto length = static_cast<double>(ticks);
  const double from = crossings.part.from * length, part = crossings.part.to * length - from;
  for (std::int64_t k = 0; k < sent; ++k) {
    const auto tick = static_cast<std::int64_t>(from + crossings.fraction(k) * part);
    event.t_ns = (interval_.t0 + std::min(tick, ticks - 1) * kEventTimeUnit).count();
    events.push_back(event);
  }
}

template class ThresholdPixels<EqualThresholds>;
template class ThresholdPixels<OwnThresholds>;

}  // namespace saccade
