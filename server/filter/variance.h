// Variance of the samples, which steers the spatial filter.
//
// takes    the history of t
// returns  signals for the spatial filter. Where at least kTemporalFrames were accumulated: I' and D' with
// the
//          variance max(0, m2 - m1^2) of one frame's sample. Elsewhere: both smoothed over 7x7 pixels, and
//          the variance from moments smoothed alike, raised by 4/h because they are few [Falcor]
#pragma once

#include "base/tile_pool.h"
#include "filter/filter_planes.h"
#include "frame/frame.h"

namespace saccade {

inline constexpr float kTemporalFrames = 4;

struct VarianceParams {
  float sigma_l = 10;  // here an absolute difference, as no variance is known yet [Falcor]
  float sigma_n = 128;
  bool use_prev = true;    // w_prev of [E (12)] for the difference
  bool difference = true;  // off: only the primal
  bool as_falcor = false;  // the 7x7 variance may be negative, and walls seen head-on are not smoothed
};

std::chrono::nanoseconds estimateVariance(const FramePair& frames, const History& history,
                                          const VarianceParams& params, TilePool& pool, FilterPlanes& out);

}  // namespace saccade
