// The arbiter: the readout that all pixels share.
#pragma once

#include <cstdint>

#include "events/event_model.h"
#include "saccade/wire/event.h"

namespace saccade {

inline constexpr double kLeastReadout = 1e-4;  // events per second

// A queue, first in, first out. The arbiter takes an event when it is free, and is then busy for 1 /
// readout_hz. It stamps the event with the time at which it took it. An event that would wait for more than
// `buffer` others is lost. So events below the throughput keep their times. Those that are taken at t1 or
// later wait for the next interval; at the end of the stream they are not sent.
class Arbiter {
 public:
  // buffer >= 0. readout_hz >= 0; less than kLeastReadout counts as that, and 0 is any number of events at
  // once.
  Arbiter(double readout_hz, double buffer);

  // Other settings from the next interval on. Waiting events stay, and are taken at the new rate.
  void change(double readout_hz, double buffer);
  bool waits() const { return !waiting_.empty(); }  // whether events wait for the next interval

  // Replaces the events of an interval, in time order, by those taken in it. Returns how many were lost.
  std::uint64_t pass(Events& events, const Interval& interval);

 private:
  double service_ns_ = 0, longest_wait_ns_ = 0;
  double free_ns_ = 0;  // when it is free again, since the start of the interval
  Events waiting_;      // taken later; at most buffer + 1 between intervals
};

}  // namespace saccade
