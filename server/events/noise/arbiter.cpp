#include "events/noise/arbiter.h"

#include <algorithm>

namespace saccade {

Arbiter::Arbiter(double readout_hz, double buffer)
    : service_ns_(1e9 / std::max(readout_hz, 1e-4)), longest_wait_ns_(buffer * service_ns_) {}

std::uint64_t Arbiter::pass(Events& events, const Interval& interval) {
  std::uint64_t lost = 0;
  for (Event e : events) {
    const auto arrival = static_cast<double>((TimeNs(e.t_ns) - interval.t0).count());
    if (free_ns_ - arrival > longest_wait_ns_) {
      ++lost;
      continue;
    }
    const double taken = std::max(arrival, free_ns_);
    free_ns_ = taken + service_ns_;
    const std::int64_t unit = kEventTimeUnit.count();
    e.t_ns = interval.t0.count() + static_cast<std::int64_t>(taken) / unit * unit;
    waiting_.push_back(e);
  }
  free_ns_ = std::max(0.0, free_ns_ - static_cast<double>((interval.t1 - interval.t0).count()));
  const auto later =
      std::ranges::partition_point(waiting_, [&](const Event& e) { return TimeNs(e.t_ns) < interval.t1; });
  events.assign(waiting_.begin(), later);
  waiting_.erase(waiting_.begin(), later);
  giveBackSlack(waiting_);
  return lost;
}

}  // namespace saccade
