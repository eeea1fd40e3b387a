// One iteration of the joint a-trous filter of primal and difference [E (3), (4), (12)].
//
// takes    signals with their variances; the features of both frames
// returns  signals filtered with a kernel of spacing `step`, and their variances
#pragma once

#include "base/pool_handle.h"
#include "filter/edge_stopping.h"
#include "filter/filter_planes.h"
#include "frame/frame.h"

namespace saccade {

enum class AtrousKernel {
  k5x5,  // {1, 2/3, 1/6} by distance on each axis
  k3x3,  // {0.44198, 0.27901}, a Gaussian [RELAX]: 9 taps instead of 25
};

struct AtrousParams {
  float sigma_z = 1;
  float sigma_n = 128;
  float sigma_l = 10;                // primal
  float sigma_l_diff = 10;           // difference
  bool primal = true;                // off: only the difference, which must be on
  bool difference = true;            // off: only the primal
  float least_slope = kLeastSlope;   // edge_stopping.h
  bool repeat_edge_variance = true;  // outside the picture; off: the variance there is the border's 0
  bool use_prev = true;  // w_diff = w_curr w_prev [E (12)]; off: w_diff = w_curr (ablation of Fig. 9 B)
  AtrousKernel kernel = AtrousKernel::k5x5;
};

inline constexpr int kMaxAtrousStep = 16;  // 2 * step must stay within Image::kBorder

// Returns the CPU time over all threads.
std::chrono::nanoseconds atrousIteration(const FramePair& frames, const AtrousParams& params, int step,
                                         const FilterPlanes& in, const PoolHandle& pool, FilterPlanes& out);

}  // namespace saccade
