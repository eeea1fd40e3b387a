// Measures the law of Appendix B: the false events that the noise dL - dL_truth makes.
//
// For an unchanging truth, a change d makes |d| / C events in the mean over the threshold phase [E (31)]. All
// are false: E[K] = mean |noise| / C [E (32)], or sqrt(2 / pi) sigma / C for Gaussian noise [E (33)].
//
// Let the truth change by r, with the same phase and |d| + |r| <= C. With equal signs, the larger of d and r
// crosses where the smaller does not, so false + missed = ||d| - |r|| / C. With opposite signs they cross at
// the two ends of the cell, never both, so false + missed = (|d| + |r|) / C. Both are |noise| / C.
#pragma once

#include "eval/bench/sequence.h"

namespace saccade::eval {

// Of noise over pixel-frames.
struct NoiseSize {
  double mean_abs = 0, sigma = 0;
  double sigma_trimmed = 0;  // without values beyond kOutlierSigmas sigma of the mean, removed once
};
inline constexpr double kOutlierSigmas = 5;
NoiseSize noiseSize(const std::vector<float>& noise);  // 0 if empty

// Noise and events of some pixel-frames. Rates are per pixel-frame of these, NaN if there are none.
struct QuietEvents {
  double share = 0;  // of all pixel-frames
  NoiseSize noise;
  // One of two sensors draws a fresh phase in each frame, as the law assumes. The other accumulates from
  // frame to frame, with OFF events 2 C below the next ON.
  double fresh_phase = 0, accumulating = 0;
};
struct MovingEvents {
  double share = 0;
  NoiseSize noise;
  double false_and_missed = 0;  // at one phase for method and truth, fresh in each frame
};

// All events are counted, not integrated over the phase, which would assume the law.
struct FalseEvents {
  QuietEvents quiet;        // where |dL_truth| <= kQuiet C
  MovingEvents all, small;  // everywhere; where |dL| + |dL_truth| <= C
};
inline constexpr double kQuiet = 0.01;

// `bias` is I_eps; thresholds C. Both sequences are of the same frames.
FalseEvents countFalseEvents(const ChangeSequence& run, const ChangeSequence& truth, double bias, double C);

}  // namespace saccade::eval
