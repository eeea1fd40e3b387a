// Counts, rates and equal times of a stream of events.
#pragma once

#include <cstdint>

#include "saccade/wire/event.h"

namespace saccade::eval {

// Takes the events of a stream in order of time, some at a time. Keeps none of them.
class StreamSummary {
 public:
  void add(const Events& events);

  std::uint64_t events() const { return events_; }
  double seconds() const;  // from the first event to the last; 0 with less than two
  double rate() const;     // events per second; NaN where they take no time
  double onShare() const;  // of ON events; NaN without events
  // The share of the events whose time another one has too (TIDES, 2026). NaN without events.
  double sameTimeShare() const;
  // The share that a Poisson process of that rate would have, with times in whole microseconds.
  double sameTimeByChance() const;
  std::uint64_t mostAtOneTime() const;

 private:
  std::uint64_t alone() const { return alone_ + (at_last_ == 1); }

  std::uint64_t events_ = 0, on_ = 0;
  std::uint64_t alone_ = 0, most_ = 0;  // events that have their time for themselves; before the last time
  std::uint64_t at_last_ = 0;           // events of the last time
  std::int64_t first_ns_ = 0, last_ns_ = 0;
};

}  // namespace saccade::eval
