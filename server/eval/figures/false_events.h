// Appendix B measured: how many false events the noise of dL makes, whatever the method. The noise is
// dL - dL_truth.
//
// Where the truth stands still, a change d makes |d| / C events in the mean over the threshold phase
// [E (31)], and all of them are false: E[K] = mean |noise| / C [E (32)], sqrt(2 / pi) sigma / C if the noise
// is Gaussian [E (33)].
//
// Where the truth moves by r, let method and truth have the same phase, and |d| + |r| <= C. Of one sign, the
// larger of them crosses where the smaller does not: false + missed = ||d| - |r|| / C. Of opposite signs they
// cross at the two ends of the cell, never both: false + missed = (|d| + |r|) / C. Either is |noise| / C.
#pragma once

#include "eval/bench/sequence.h"

namespace saccade::eval {

// Of noise over pixel-frames.
struct NoiseSize {
  double mean_abs = 0, sigma = 0;
  double sigma_trimmed = 0;  // without what lies beyond kOutlierSigmas sigma of the mean, taken out once
};
inline constexpr double kOutlierSigmas = 5;
NoiseSize noiseSize(const std::vector<float>& noise);  // 0 if empty

// Noise and events of some pixel-frames. Rates are per pixel-frame of these, NaN if there are none.
struct QuietEvents {
  double share = 0;  // of all pixel-frames
  NoiseSize noise;
  // Of two sensors: with a fresh phase in each frame, as the law has it; and accumulating from frame to
  // frame, where an OFF event lies 2 C below the next ON.
  double fresh_phase = 0, accumulating = 0;
};
struct MovingEvents {
  double share = 0;
  NoiseSize noise;
  double false_and_missed = 0;  // at one phase for method and truth, fresh in each frame
};

// All events are counted, not integrated over the phase: the law is not to be its own witness.
struct FalseEvents {
  QuietEvents quiet;        // where |dL_truth| <= kQuiet C
  MovingEvents all, small;  // everywhere; where |dL| + |dL_truth| <= C
};
inline constexpr double kQuiet = 0.01;

// `bias` is I_eps; thresholds C. Both sequences are of the same frames.
FalseEvents countFalseEvents(const ChangeSequence& run, const ChangeSequence& truth, double bias, double C);

}  // namespace saccade::eval
