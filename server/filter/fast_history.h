// A second history of few frames, which bounds the first where light has changed [RELAX].
#pragma once

#include "base/pool_handle.h"
#include "filter/filter_planes.h"
#include "frame/frame.h"

namespace saccade {

struct FastHistory {
  FastHistory(int w, int h) : I(w, h), D(w, h), R(w, h) {}
  ImageF I, D, R;  // as those of History, over at most `most` frames
};

// Follows the motion vectors, as accumulate() does. `length`, `length_prev`: History::length of both frames.
// `I_prev2`: the fast I' of two frames ago.
std::chrono::nanoseconds accumulateFast(const FramePair& frames, const IlluminationSamples& samples,
                                        float most, const ImageF& length, const ImageF& length_prev,
                                        const FastHistory& prev, const ImageF& I_prev2,
                                        const PoolHandle& pool, FastHistory& out);

// Clamps I' and D' of a history to the values of the fast one in 5x5 pixels. The range is their mean, plus
// and minus so many of their standard deviations.
std::chrono::nanoseconds clampHistory(const FastHistory& fast, float deviations, const PoolHandle& pool,
                                      History& history);

}  // namespace saccade
