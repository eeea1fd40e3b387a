// How well the odds that events are artefacts agree with the share that is.
#pragma once

#include <array>

#include "eval/bench/sequence.h"

namespace saccade::eval {

inline constexpr int kOddsBins = 10;

struct OddsBin {
  double events = 0;
  double odds = 0, false_share = 0;  // means over the events; 0 if there are none
};

struct OddsBins {
  std::array<OddsBin, kOddsBins> bins;  // of odds in [i, i + 1) / kOddsBins; 1 is in the last

  OddsBin mean(int first = 0, int last = kOddsBins) const;  // of the bins first to last - 1
  // The mean of |odds - false_share| over the bins, weighted by their events; 0 if there are none.
  double error() const;
};

// Judges the events of a sensor with the bias I_eps and thresholds C. Takes an event in a pixel whose
// brightness changes by dL, and by `ref` in truth. The share clamp(1 - ref / dL, 0, 1) is false:
// artefact_odds.h. Both sequences are of the same frames.
OddsBins binsOfOdds(const ChangeSequence& run, const ChangeSequence& truth, double bias, double C);

}  // namespace saccade::eval
