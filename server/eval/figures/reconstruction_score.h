// Scores a reconstruction of brightness over a sequence of frames: its events, its drift and its noise.
#pragma once

#include "eval/bench/sequence.h"

namespace saccade::eval {

struct ReconstructionScore {
  double false_events = 0, missed_events = 0;  // per pixel-frame, integrated over the phase; event_rates.h
  double count_error = 0, voxel_error = 0;     // of the sensor's events, event_streams.h
  double drift = 0;                            // median over the pixels of the error of L_T - L_0
  double offset = 0;                           // of the error of L_T
  double high_rms = 0;  // of the error of dL above a quarter of the frame rate: root of its mean power
};

// Compares with the events and the dL of the truth, which needs no reconstruction; the rest of `config` holds
// for both. Needs two or more frames of one length.
ReconstructionScore scoreReconstruction(const ChangeSequence& run, const ChangeSequence& truth,
                                        const SensorConfig& config);

}  // namespace saccade::eval
