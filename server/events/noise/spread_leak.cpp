#include "events/noise/spread_leak.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "events/noise/rate_spread.h"

namespace saccade {

SpreadLeak::SpreadLeak(const SensorConfig& config, int width, int height)
    : key_(noiseKey(config.seed, NoiseNumbers::kLeakPhase)),
      width_(width),
      periods_ns_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
  heap_.reserve(periods_ns_.size());
  const NoiseConfig& noise = config.noise;
  for (std::uint32_t pixel = 0; pixel < periods_ns_.size(); ++pixel)
    periods_ns_[pixel] =
        static_cast<float>(1e9 / (noise.leak_hz * rateFactor(noise.rate_spread, config.seed, pixel)));
}

double SpreadLeak::phaseOf(std::uint32_t pixel) const {
  return uniform(hashKey(key_, pixel));
}

// The first event of each pixel at t0 or later.
void SpreadLeak::start(double t0_ns) {
  for (std::uint32_t pixel = 0; pixel < periods_ns_.size(); ++pixel) {
    const double period = static_cast<double>(periods_ns_[pixel]), u = phaseOf(pixel);
    heap_.push_back({(std::max(0.0, std::ceil(t0_ns / period - u)) + u) * period, pixel});
  }
  std::make_heap(heap_.begin(), heap_.end(), std::greater<>());
}

void SpreadLeak::generate(const IntensityChange& change, NoiseSink& sink) {
  if (heap_.empty()) start(static_cast<double>(change.t0.count()));
  while (heap_.front().t_ns < static_cast<double>(change.t1.count())) {
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    Next& next = heap_.back();
    const std::int64_t tick = static_cast<std::int64_t>(next.t_ns) / kTimeUnitNs * kTimeUnitNs;
    sink.add(std::max(tick, change.t0.count()), next.pixel, width_, 1);
    // The number of the event is counted anew, so that rounding does not add up.
    const double period = static_cast<double>(periods_ns_[next.pixel]), u = phaseOf(next.pixel);
    next.t_ns = (std::round(next.t_ns / period - u) + 1 + u) * period;
    std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
  }
}

}  // namespace saccade
