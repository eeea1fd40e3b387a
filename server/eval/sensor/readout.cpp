#include "eval/sensor/readout.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/hash_rng.h"
#include "events/noise/arbiter.h"
#include "events/noise/noise_numbers.h"

namespace saccade::eval {
namespace {

constexpr double kEvents = 4e5;
constexpr double kLongest = 1e9;    // seconds of stream time
constexpr double kSettling = 0.25;  // share of the events that comes before what is measured

// A Poisson process. The pixels number its events.
Events poisson(double hz) {
  const auto count = static_cast<std::uint32_t>(std::min(kEvents, kLongest * hz));
  const std::int64_t unit = kEventTimeUnit.count();
  Events events;
  double t = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    t -= 1e9 / hz * std::log(uniform(hashKey(1, i)));
    events.push_back({static_cast<std::int64_t>(t) / unit * unit, static_cast<std::uint16_t>(i),
                      static_cast<std::uint16_t>(i >> 16), 1});
  }
  return events;
}

std::size_t numberOf(const Event& e) {
  return static_cast<std::size_t>(e.y) << 16 | e.x;
}

// Those that are taken, in order, until the last of `offered` comes.
Events taken(const NoiseConfig& noise, Events events) {
  const Interval interval{TimeNs(0), TimeNs(events.back().t_ns) + kEventTimeUnit, 1};
  if (noise.readout_hz > 0) Arbiter(noise.readout_hz, noise.readout_buffer).pass(events, interval);
  return events;
}

}  // namespace

ReadoutLoad measureReadout(const NoiseConfig& noise, double offered_hz) {
  const Events offered = poisson(offered_hz);
  const Events sent = taken(noise, offered);
  const auto first = static_cast<std::size_t>(kSettling * static_cast<double>(sent.size()));
  const std::size_t arrivals = numberOf(sent.back()) - numberOf(sent[first]),
                    events = sent.size() - 1 - first;
  double wait = 0;
  for (std::size_t i = first; i < sent.size(); ++i)
    wait += seconds(TimeNs(sent[i].t_ns - offered[numberOf(sent[i])].t_ns));
  return {static_cast<double>(events) / seconds(TimeNs(sent.back().t_ns - sent[first].t_ns)),
          {1 - static_cast<double>(events) / static_cast<double>(arrivals),
           wait / static_cast<double>(events + 1)}};
}

ReadoutLoad expectedReadout(const NoiseConfig& noise, double offered_hz) {
  if (noise.readout_hz == 0) return {offered_hz, {0, 0}};
  const QueueLoad queue =
      expectedQueue(offered_hz, readoutRate(noise), static_cast<int>(std::floor(noise.readout_buffer)));
  return {offered_hz * (1 - queue.lost), queue};
}

double readoutRate(const NoiseConfig& noise) {
  return noise.readout_hz > 0 ? std::max(noise.readout_hz, kLeastReadout) : 1e6;
}

}  // namespace saccade::eval
