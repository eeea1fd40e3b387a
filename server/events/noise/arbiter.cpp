#include "events/noise/arbiter.h"

#include <algorithm>
#include <limits>

namespace saccade {

Arbiter::Arbiter(double readout_hz, double buffer) {
  change(readout_hz, buffer);
}

void Arbiter::change(double readout_hz, double buffer) {
  const double before_ns = service_ns_, waiting = static_cast<double>(waiting_.size());
  service_ns_ = readout_hz > 0 ? 1e9 / std::max(readout_hz, kLeastReadout) : 0;
  longest_wait_ns_ = readout_hz > 0 ? buffer * service_ns_ : std::numeric_limits<double>::infinity();
  // The first is taken as before, when the arbiter is free. All of them have arrived already.
  free_ns_ = std::max(0.0, free_ns_ + waiting * (service_ns_ - before_ns));
  const std::int64_t unit = kEventTimeUnit.count();
  for (std::size_t i = 1; i < waiting_.size(); ++i)
    waiting_[i].t_ns =
        waiting_[0].t_ns + static_cast<std::int64_t>(static_cast<double>(i) * service_ns_) / unit * unit;
}

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
    if (!waiting_.empty()) e.t_ns = std::max(e.t_ns, waiting_.back().t_ns);  // change() may have rounded
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
