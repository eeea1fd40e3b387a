// Puts the events of an interval in time order.
#pragma once

#include "events/event_model.h"

namespace saccade {

// A stable radix sort by time: ties keep the order in which the model appended them. Frames are short (2000
// us at 500 Hz), so that one pass over 11 bits is the rule.
class TimeOrder {
 public:
  void sort(Events& events, const Interval& interval);

 private:
  Events scratch_;
};

}  // namespace saccade
