// How far the jitter moves events.
#pragma once

#include "eval/sensor/sensor_run.h"

namespace saccade::eval {

// Standard deviation of t' - t in seconds. Here t' is the time that the sensor gives to the first ON event of
// a pixel, and t that of a sensor without jitter. Frames are `interval` apart, a multiple of kEventTimeUnit.
// NaN where no pixel sends anything.
double measureTimeError(const SensorSetup& setup, TimeNs interval);

// A normal distribution that is mirrored at the ends of an interval of length T is the heat kernel of a rod
// with closed ends. For t uniform in T its cosine series gives [ours]
//
//   (t' - t)^2 = 16 T^2 / pi^4 sum over odd n of (1 - exp(-(n pi s / T)^2 / 2)) / n^4
//
// which is s^2 for a long interval, and T^2 / 6 for a short one.
double expectedTimeError(const NoiseConfig& noise, TimeNs interval);

}  // namespace saccade::eval
