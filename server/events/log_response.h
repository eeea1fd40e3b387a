// The lin-log response of a pixel, from intensity to log brightness [E (1), (20), (21)].
#pragma once

#include "frame/intensity_change.h"

namespace saccade {

// dL = log(1 + dI / (I_eps + I_prev)) [E (21)], relative error below 1e-6.
//   I_prev and I_prev + dI are clamped to [0, kMaxLuminance] (log_ratio.h).
//   A pixel with NaN or Inf in I_prev or dI gives 0. dI = 0 gives exactly 0.
// `bias` is I_eps, within ranges::kBias. Leaves the border of `dL` as it is.
void logResponse(const IntensityChange& change, float bias, ImageF& dL);

}  // namespace saccade
