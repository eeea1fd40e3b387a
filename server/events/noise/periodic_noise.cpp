#include "events/noise/periodic_noise.h"

#include <algorithm>
#include <cmath>

#include "base/hash_rng.h"

namespace saccade {

PeriodicNoise::PeriodicNoise(const std::vector<std::uint32_t>& pixels, double rate_hz, std::uint64_t key,
                             int width)
    : period_ns_(1e9 / rate_hz), width_(width) {
  calendar_.reserve(pixels.size());
  for (const std::uint32_t pixel : pixels) {
    calendar_.push_back((hashKey(key, pixel) & 0xffffffff00000000u) | pixel);
  }
  std::ranges::sort(calendar_);
}

double PeriodicNoise::timeOf(double cycle, std::uint64_t entry) const {
  return (cycle + (static_cast<double>(entry >> 32) + 0.5) * 0x1p-32) * period_ns_;
}

void PeriodicNoise::generate(const IntensityChange& change, NoiseSink& sink) {
  const auto t0 = static_cast<double>(change.t0.count()), t1 = static_cast<double>(change.t1.count());
  if (calendar_.empty()) return;
  // One cycle early, so that rounding misses none.
  for (double cycle = std::max(0.0, std::floor(t0 / period_ns_) - 1);; ++cycle) {
    auto entry = std::partition_point(calendar_.begin(), calendar_.end(),
                                      [&](std::uint64_t e) { return timeOf(cycle, e) < t0; });
    for (; entry != calendar_.end(); ++entry) {
      const double t = timeOf(cycle, *entry);
      if (t >= t1) return;
      const std::int64_t tick = static_cast<std::int64_t>(t) / kTimeUnitNs * kTimeUnitNs;
      sink.add(std::max(tick, change.t0.count()), static_cast<std::uint32_t>(*entry), width_, 1);
    }
  }
}

}  // namespace saccade
