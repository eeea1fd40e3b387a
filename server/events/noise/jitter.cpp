#include "events/noise/jitter.h"

#include <algorithm>
#include <cmath>

#include "events/noise/noise_numbers.h"

namespace saccade {
namespace {

// `t` folded into [0, length).
double mirror(double t, double length) {
  const double folded = std::fmod(std::abs(t), 2 * length);
  return folded < length ? folded : 2 * length - folded;
}

}  // namespace

Jitter::Jitter(double sigma_s, std::uint64_t seed)
    : sigma_ns_(1e9 * sigma_s), key_(noiseKey(seed, NoiseNumbers::kJitter)) {}

void Jitter::move(Events& events, const Interval& interval) const {
  const std::uint64_t key = hashKey(key_, interval.frame);
  const std::int64_t t0 = interval.t0.count(), ticks = (interval.t1 - interval.t0) / kEventTimeUnit;
  const double unit = static_cast<double>(kEventTimeUnit.count());
  for (std::size_t i = 0; i < events.size(); ++i) {
    // The middle of its tick: rounding down then has no bias.
    const double t =
        static_cast<double>(events[i].t_ns - t0) + unit / 2 + sigma_ns_ * gaussian(hashKey(key, i));
    const auto tick = static_cast<std::int64_t>(mirror(t, static_cast<double>(ticks) * unit) / unit);
    events[i].t_ns = t0 + std::min(tick, ticks - 1) * kEventTimeUnit.count();
  }
}

}  // namespace saccade
