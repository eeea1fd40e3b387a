// The noise of what pairs of paths tell.
#pragma once

#include "frame/frame.h"

namespace saccade {

inline bool hasPairs(const PairSamples& pairs, int x, int y) {
  return pairs.count.at(x, y) > 0;
}

// The variances of a pixel's mean change of illumination, and of its illumination now. The pixel must have
// pairs.
float varianceOfChange(const PairSamples& pairs, int x, int y);
float varianceOfIllumination(const Frame& now, int x, int y);
// The variance of a coat's light now, likewise.
float varianceAround(const CoatSamples& coats, int x, int y);

// A change that its noise may have made is none, or it would be an event where nothing happens. It is the
// positive part of James and Stein (1961), with less of the noise.
float provenChange(float d, float var);

}  // namespace saccade
