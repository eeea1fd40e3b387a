// The planes that the stages of the filter exchange: demodulated illumination or its change, width x height.
#pragma once

#include "frame/image.h"

namespace saccade {

// One noisy sample per pixel of this frame.
struct IlluminationSamples {
  IlluminationSamples(int w, int h) : i(w, h), d(w, h) {}
  ImageF i;  // i_t, from both passes [E (9)]
  ImageF d;  // i_t - i_{t-1}, from the passes that share seeds [E (8)]
};

// Input and output of the spatial filter: primal and difference, each with its variance.
struct FilterPlanes {
  FilterPlanes(int w, int h) : i(w, h), var_i(w, h), d(w, h), var_d(w, h) {}
  ImageF i, var_i;
  ImageF d, var_d;
};

// The state of temporal accumulation after frame t.
struct History {
  History(int w, int h) : I(w, h), D(w, h), R(w, h), m1(w, h), m2(w, h), q1(w, h), q2(w, h), length(w, h) {}
  ImageF I;       // I'_t, or the filtered picture after feedback
  ImageF D;       // D'_t, the accumulated difference; likewise
  ImageF R;       // R_t = W_t I'_{t-1}: what was reprojected to make I'_t
  ImageF m1, m2;  // accumulated moments of i
  ImageF q1, q2;  // accumulated moments of d
  ImageF length;  // accumulated frames; 1: the history was lost here; 0: before frame 0
};

}  // namespace saccade
