// Variance of the samples, which steers the spatial filter.
//
// takes    the history of t
// returns  signals for the spatial filter, with the variance of one frame's sample
//          pixels with at least kTemporalFrames frames: I' and D', variance max(0, m2 - m1^2)
//          other pixels: I', D' and the moments smoothed over 7x7 pixels; the variance is raised by 4/h, as
//          h frames are few [Falcor]
#pragma once

#include "base/pool_handle.h"
#include "filter/edge_stopping.h"
#include "filter/filter_planes.h"
#include "frame/frame.h"

namespace saccade {

inline constexpr float kTemporalFrames = 4;

struct VarianceParams {
  float sigma_l = 10;  // an absolute difference here, as no variance is known yet [Falcor]
  float sigma_n = 128;
  bool use_prev = true;             // w_prev of [E (12)] for the difference
  bool difference = true;           // off: only the primal
  float least_slope = kLeastSlope;  // edge_stopping.h
  float least_variance = 0;         // lower bound of the 7x7 variance
};

// Returns the CPU time over all threads.
std::chrono::nanoseconds estimateVariance(const FramePair& frames, const History& history,
                                          const VarianceParams& params, const PoolHandle& pool,
                                          FilterPlanes& out);

}  // namespace saccade
