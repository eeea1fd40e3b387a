// Albedo demodulation of samples, and modulation of the filtered result (paper, 4.4.3).
#pragma once

#include <algorithm>

#include "base/tile_pool.h"
#include "filter/signals.h"
#include "frame/frame.h"
#include "frame/intensity_change.h"

namespace saccade {

inline constexpr float kAlbedoFloor = 1e-3f;  // the same on the way in and out

// The albedo that light is divided by: floored, or 1 where demodulation is switched off.
inline float filterAlbedo(float A, bool demodulate) {
  return demodulate ? std::max(A, kAlbedoFloor) : 1.f;
}

// i = (I - E) / A [E (17)]. The first frame of a feed has no difference: call with frames.prev == frames.cur,
// and d is 0. Samples that are not finite count as 0.
std::chrono::nanoseconds demodulate(const FramePair& frames, bool demodulate, TilePool& pool,
                                    IlluminationSamples& out);

// dI = A_t D[di] + (A_t - A_{t-1}) D[i_{t-1}] + (E_t - E_{t-1}) [E (19)], and the two primal pictures.
// `i_prev`, `var_i_prev`: the filtered primal of the previous frame. Variances are scaled by
// `variance_scale`.
std::chrono::nanoseconds modulate(const FramePair& frames, bool demodulate, float variance_scale,
                                  const Signals& filtered, const ImageF& i_prev, const ImageF& var_i_prev,
                                  TilePool& pool, IntensityChange& out);

}  // namespace saccade
