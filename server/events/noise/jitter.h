// The jitter of event times.
#pragma once

#include <cstdint>

#include "events/event_model.h"
#include "saccade/wire/event.h"

namespace saccade {

// t becomes t + sigma N(0, 1). A time beyond an end of the interval is mirrored there: it stays inside, and
// events that are uniform in time remain so. An error longer than the interval becomes a uniform time.
class Jitter {
 public:
  Jitter(double sigma_s, std::uint64_t seed);

  // Moves the events of an interval; their order in time is lost.
  void move(Events& events, const Interval& interval) const;

 private:
  double sigma_ns_;
  std::uint64_t key_;
};

}  // namespace saccade
