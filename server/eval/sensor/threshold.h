// The threshold of a sensor over its pixels: who answers a step, and after how large a change.
#pragma once

#include <vector>

#include "eval/sensor/sensor_run.h"

namespace saccade::eval {

// The share of the pixels that answer a step of log intensity from `I` by an event of its sign, within 50 ms.
// The pixels are at any level between their thresholds when it comes.
double shareAnswering(const SensorSetup& setup, double I, double step);

// The change of log intensity, near `I`, from the first to the second event of each pixel. It is the pixel's
// threshold, as its level is known after an event. The change is slow: no low pass delays the second event
// more than the first. `sign`: 1 for ON, -1 for OFF. Ascending, without pixels that sent fewer than two
// events.
std::vector<double> pixelThresholds(const SensorSetup& setup, double I, int sign);

// The share of `pixels` whose threshold is at most `change`.
double shareWithin(const std::vector<double>& thresholds, double change, int pixels);

// The change within which the threshold of a share of `pixels` lies; NaN if fewer pixels have one.
double changeOfShare(const std::vector<double>& thresholds, double share, int pixels);

}  // namespace saccade::eval
