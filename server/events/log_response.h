// From intensity to brightness: the lin-log response of a pixel [E (1), (20), (21)].
#pragma once

#include "frame/intensity_change.h"

namespace saccade {

// dL = log(1 + dI / (I_eps + I_prev)) [E (21)], relative error below 1e-6.
//   I_prev + dI is clamped at 0 from below and kMaxLuminance (log_ratio.h) from above, I_prev likewise.
//   A pixel with NaN or Inf in I_prev or dI gives 0, and so does dI = 0, exactly.
// `bias` is I_eps, [1e-12, 1e6]. The border of `dL` is left as it is.
void logResponse(const IntensityChange& change, float bias, ImageF& dL);

}  // namespace saccade
