// False and missed events, and errors in time, against a reference that is fine in time.
#pragma once

#include <cstdint>

#include "saccade/wire/event.h"

namespace saccade::eval {

// Events are counted per pixel, polarity and window of time; windows begin at time 0. Of `n` events where the
// reference has `m`, n - m are false, or m - n are missed. The k-th of the others is compared with the k-th
// of the reference.
struct WindowErrors {
  double false_share = 0, missed_share = 0;  // of the events of the reference; NaN if it has none
  double time = 0;                           // mean |dt| over the events compared, in windows; NaN if none is
};

// Both streams cover the same pixels and the same time, at most 2^31 windows. `window_ns` > 0.
WindowErrors windowErrors(const Events& x, const Events& reference, double window_ns);

}  // namespace saccade::eval
