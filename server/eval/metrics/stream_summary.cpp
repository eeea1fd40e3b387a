#include "eval/metrics/stream_summary.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace saccade::eval {
namespace {

double ratio(double part, double whole) {
  return whole > 0 ? part / whole : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

void StreamSummary::add(const Events& events) {
  for (const Event& e : events) {
    if (events_ == 0) first_ns_ = e.t_ns;
    if (events_ > 0 && e.t_ns == last_ns_) {
      ++at_last_;
    } else {
      alone_ += at_last_ == 1;
      most_ = std::max(most_, at_last_);
      at_last_ = 1;
    }
    last_ns_ = e.t_ns;
    on_ += e.p;
    ++events_;
  }
}

double StreamSummary::seconds() const {
  return static_cast<double>(last_ns_ - first_ns_) * 1e-9;
}

double StreamSummary::rate() const {
  return ratio(static_cast<double>(events_), seconds());
}

double StreamSummary::onShare() const {
  return ratio(static_cast<double>(on_), static_cast<double>(events_));
}

double StreamSummary::sameTimeShare() const {
  return ratio(static_cast<double>(events_ - alone()), static_cast<double>(events_));
}

double StreamSummary::sameTimeByChance() const {
  return -std::expm1(-rate() * kTimeUnitNs * 1e-9);
}

std::uint64_t StreamSummary::mostAtOneTime() const {
  return std::max(most_, at_last_);
}

}  // namespace saccade::eval
