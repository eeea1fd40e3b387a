// The change of pixels whose surfaces share no light, by pairs of paths. Both paths of a pair have the same
// random numbers. One starts at what the pixel shows in this frame, the other at what it showed before.
#pragma once

#include "frame/image.h"

namespace saccade {

// Planes are width x height, Rec. 709 luminance. FrameSamples::I2 is the mean of the paths in this frame.
struct PairSamples {
  PairSamples(int w, int h) : before(w, h), variance(w, h), count(w, h), more(w, h) {}
  ImageF before;    // mean of the paths in the frame before, emission included
  ImageF variance;  // of the difference of illumination of one pair, >= 0
  ImageF count;     // pairs of the pixel; 0: it has none, and the other planes hold nothing
  ImageF more;      // of them, those that it got as its first ones had too much noise; 0: none
};

// The light that the coats of plastics reflect: their interfaces, without the bases below. A pixel that shows
// one in one frame alone reflects none in the other. In `pairs`, variance is that of reflected light.
struct CoatSamples {
  CoatSamples(int w, int h) : now(w, h), pairs(w, h) {}
  ImageF now;  // mean of the paths in this frame
  PairSamples pairs;
};

}  // namespace saccade
