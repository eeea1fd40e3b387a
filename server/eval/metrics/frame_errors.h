// The errors of one frame of a method: of the change of intensity, of the change of brightness, and of
// events.
#pragma once

#include "eval/metrics/event_rates.h"
#include "frame/intensity_change.h"

namespace saccade::eval {

struct FrameErrors {
  double dI_l1, dI_mape;  // relative L1 and MAPE of dI
  double dL_l1, dL_mape;  // and of dL [E (21)], each with its own I_prev
  EventRates rates;       // integrated over the threshold phase
};

// Reads only dI and I_prev. `bias` is I_eps > 0, `threshold` C > 0. A pixel with NaN or Inf has dL = 0, as
// in a sensor; it shows in the errors of dI.
FrameErrors frameErrors(const IntensityChange& x, const IntensityChange& ref, float bias, double threshold);

}  // namespace saccade::eval
