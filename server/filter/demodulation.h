// Albedo demodulation of samples, and modulation of the filtered result (paper, 4.4.3).
#pragma once

#include <algorithm>
#include <cmath>

#include "base/pool_handle.h"
#include "filter/filter_planes.h"
#include "frame/frame.h"
#include "frame/illumination.h"
#include "frame/intensity_change.h"

namespace saccade {

// The divisor of light before it is filtered.
enum class Demodulation {
  kNone,       // 1 (ablation of Fig. 9 D)
  kAlbedo,     // the albedo, floored
  kEightBits,  // the same rounded to 1/255, as Falcor's path tracer hands it over
};

inline float filterAlbedo(float A, Demodulation by) {
  if (by == Demodulation::kNone) return 1;
  return std::max(by == Demodulation::kAlbedo ? A : std::round(A * 255) / 255, kAlbedoFloor);
}

// The factor that filtered light is multiplied by. A surface of albedo 0 reflects nothing, even where the
// filter has spread light onto it [ours].
inline float modulationAlbedo(float A, Demodulation by) {
  return A == 0 && by == Demodulation::kAlbedo ? 0 : filterAlbedo(A, by);
}

// i = (I - E) / A [E (17)]. d of a first frame is 0.
// Illumination that is not finite counts as 0, and so does any beyond 1e18, whose moments would overflow.
std::chrono::nanoseconds demodulate(const FramePair& frames, Demodulation by, const PoolHandle& pool,
                                    IlluminationSamples& out);

// dI = A_t D[di] + (A_t - A_{t-1}) D[i_{t-1}] + (E_t - E_{t-1}) [E (19)], and the two primal pictures.
// `i_prev`, `var_i_prev`: the filtered primal of the previous frame. Variances are scaled by
// `variance_scale`.
std::chrono::nanoseconds modulate(const FramePair& frames, Demodulation by, float variance_scale,
                                  const FilterPlanes& filtered, const ImageF& i_prev,
                                  const ImageF& var_i_prev, const PoolHandle& pool, IntensityChange& out);

}  // namespace saccade
