// Sorts the events of an interval by time.
#pragma once

#include "events/event_model.h"

namespace saccade {

// A stable radix sort: ties keep the order in which the model appended them. A frame of 500 Hz lasts 2000 us,
// so that one pass over 11 bits suffices.
class TimeOrder {
 public:
  void sort(Events& events, const Interval& interval);

 private:
  Events scratch_;
};

}  // namespace saccade
