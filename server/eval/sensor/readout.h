// The readout under load.
#pragma once

#include "eval/sensor/queue.h"
#include "events/noise/noise_config.h"

namespace saccade::eval {

struct ReadoutLoad {
  double delivered_hz;  // events per second
  QueueLoad queue;      // as measured
};

// Offers a Poisson process of `offered_hz` events per second to the readout of a sensor, and measures once
// its queue has filled. Event times are whole kEventTimeUnit, before and after it.
ReadoutLoad measureReadout(const NoiseConfig& noise, double offered_hz);

// The same by formula, without that rounding of times.
ReadoutLoad expectedReadout(const NoiseConfig& noise, double offered_hz);

// Events per second that the readout can take; 1e6 where it takes any number.
double readoutRate(const NoiseConfig& noise);

}  // namespace saccade::eval
