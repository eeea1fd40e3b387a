// Stimuli that measure a sensor: a uniform picture whose intensity changes over time.
#pragma once

#include <vector>

#include "base/units.h"

namespace saccade::eval {

struct StimulusFrame {
  TimeNs t;  // a multiple of kEventTimeUnit
  double I;  // scene luminance of all pixels, > 0
};
// At rising times, at least two. The sensor takes log brightness as linear between two frames.
using Stimulus = std::vector<StimulusFrame>;

// The intensity `I` for `duration_s` seconds, at least 10 ms.
Stimulus stillPicture(double I, double duration_s);

// `I` until kStepTime. A microsecond later the natural log of intensity has changed by `size`, and stays for
// `window`. The frames after the step are `shortest` apart at first, and then in growing intervals.
inline constexpr TimeNs kStepTime{50'000'000};
Stimulus stepOf(double I, double size, TimeNs window, TimeNs shortest);

// Log intensity changes evenly for `duration_s` seconds, by `size` in all, around that of `I`. It has so many
// intervals.
inline constexpr int kRampFrames = 400;
Stimulus rampOf(double I, double size, double duration_s);

// log I + amplitude sin(2 pi f t) for a whole number of cycles.
struct Sine {
  Stimulus frames;
  TimeNs period;        // 1 / f
  TimeNs settled;       // from here on whole cycles are measured
  int measured_cycles;  // so many
};
// f is at most 15 kHz, and is rounded so that frames lie on microseconds and on the extremes.
Sine sineOf(double I, double amplitude, double hz);

}  // namespace saccade::eval
