#include "feed/interval_clock.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace saccade {
namespace {

// An interval may have this share of a part more, so that rounding makes no short ones.
constexpr double kSlack = 0.01;

// The fraction of all steps at which the picture has moved by `px`, which is at most their sum.
double fractionAt(std::span<const double> steps, double px) {
  std::size_t i = 0;
  for (; i + 1 < steps.size() && px > steps[i]; ++i) px -= steps[i];
  const double within = steps[i] > 0 ? std::min(px / steps[i], 1.0) : 1;
  return (static_cast<double>(i) + within) / static_cast<double>(steps.size());
}

}  // namespace

TimeNs IntervalClock::advance(std::span<const double> steps) {
  const TimeNs end = endOf(steps);
  if (atFrame()) ++frame_;
  return now_ = end;
}

// The intervals that are left of the frame get equal motion.
TimeNs IntervalClock::endOf(std::span<const double> steps) const {
  const TimeNs end = frameEnd();
  if (!bounds_.followMotion()) return end;
  const double px = std::accumulate(steps.begin(), steps.end(), 0.0);
  const double left = static_cast<double>((end - now_) / kEventTimeUnit);
  const double shortest = std::max(1e9 / bounds_.max_rate_hz / kEventTimeUnit.count(), 1.0);
  const double parts = std::min(std::ceil(px / bounds_.px - kSlack), std::floor(left / shortest));
  if (!(parts >= 2)) return end;
  const double ticks = left * fractionAt(steps, px / parts);
  return now_ + std::llround(std::clamp(ticks, shortest, left - shortest)) * kEventTimeUnit;
}

}  // namespace saccade
