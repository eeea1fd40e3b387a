// The lin-log response of a pixel, from intensity to log brightness [E (1), (20), (21)].
#pragma once

#include "base/log_ratio.h"
#include "frame/intensity_change.h"

namespace saccade {

// dL = log(1 + dI / (I_eps + I_prev)) [E (21)], relative error below 1e-6.
//   I_prev and I_prev + dI are clamped to [0, kMaxLuminance] (log_ratio.h).
//   A pixel with NaN or Inf in I_prev or dI gives 0. dI = 0 gives exactly 0.
inline float logResponse(float I_prev, float dI, float I_eps) {
  const float prev = clampTo(I_prev, 0, kMaxLuminance);
  const float change = clampTo(dI, -prev, kMaxLuminance - prev);
  const float delta = logRatio(I_eps + prev, I_eps + (prev + change), change);
  const bool finite = dI - dI == 0 && I_prev - I_prev == 0;
  return finite ? delta : 0;
}

// The same for all pixels. `bias` is I_eps, within ranges::kBias. Leaves the border of `dL` as it is.
void logResponse(const IntensityChange& change, float bias, ImageF& dL);

}  // namespace saccade
