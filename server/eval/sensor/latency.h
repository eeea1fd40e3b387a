// The time from a step of brightness to the first event.
#pragma once

#include "eval/sensor/sensor_run.h"

namespace saccade::eval {

// Over the pixels that answer; NaN where none does.
struct Latency {
  double median_s, low_s, high_s;  // quantiles 0.5, 0.16 and 0.84
  double answered;                 // share of the pixels
};
// The jitter of event times is left out: it moves no event out of its interval, and the intervals are short.
// After a step of log intensity from `I`, to the first event of its sign within a second. The pixels are at
// any level between their thresholds when it comes.
Latency measureLatency(const SensorSetup& setup, double I, double step);

}  // namespace saccade::eval
