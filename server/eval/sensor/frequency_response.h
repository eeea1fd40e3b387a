// How a sensor follows a sinusoidal brightness.
#pragma once

#include <vector>

#include "eval/sensor/sensor_run.h"

namespace saccade::eval {

struct FrequencyPoint {
  double hz;                     // as rounded by sineOf()
  double on_events, off_events;  // per pixel and cycle
  double gain;                   // amplitude that the events tell, over the amplitude of log intensity
};

// Shows log intensity that swings by `amplitude` around that of `I`.
//
// From one extreme to the other a pixel's reference follows all of the swing but a part of a threshold. It
// ends between 0 and C+ below the top, and between 0 and C- above the bottom. On average over pixels with
// equal thresholds [ours]
//
//   2 a = (C+ + C-) / 2 + C+ N_on,   and likewise with C- N_off.
//
// The amplitude a is the mean of both. Pixels with unequal thresholds may lock to the swing: a then errs by
// at most (C+ + C-) / 4. It counts as 0 where a pixel has less than one event per cycle.
FrequencyPoint measureResponse(const SensorSetup& setup, double I, double amplitude, double hz);

// The frequency at which the gain has fallen to 1 / sqrt 2 of that of the first point: -3 dB. Between two
// points it is interpolated in their logarithms. NaN where the gain does not fall so far. `points`: by rising
// frequency.
double halfPowerFrequency(const std::vector<FrequencyPoint>& points);

}  // namespace saccade::eval
