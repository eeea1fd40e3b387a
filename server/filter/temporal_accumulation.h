// Temporal accumulation of primal and difference along motion vectors (paper, 4.4.2).
//
// takes    this frame's samples i, d; the features of both frames; the histories of t-1 and t-2
// returns  the history of t: I', D', moments, length, and R_t = W_t I'_{t-1}
#pragma once

#include "base/pool_handle.h"
#include "filter/filter_planes.h"
#include "frame/frame.h"

namespace saccade {

class TemporalGradient;

// How a surface is found in the previous frame, see surface_test.h.
enum class SurfaceTest { kSameSurface, kFalcorSurface };

struct AccumulationParams {
  float alpha = 0.1f;          // weight of the new sample, at least
  float moments_alpha = 0.2f;  // the same for the moments
  float max_history = 32;      // frames
  SurfaceTest surface_test = SurfaceTest::kSameSurface;
  bool accumulate_difference = true;           // off: D' = d (ablation of Fig. 9 C)
  bool correct_difference = true;              // off: without the last two terms of [E (16)]
  const TemporalGradient* gradient = nullptr;  // raises both weights where light has changed; nullptr: none
};

// Returns the CPU time over all threads. Without `I_prev2` it accumulates only the primal.
std::chrono::nanoseconds accumulate(const FramePair& frames, const IlluminationSamples& samples,
                                    const AccumulationParams& params, const History& prev,
                                    const ImageF* I_prev2, const PoolHandle& pool, History& out);

}  // namespace saccade
