#include "events/log_response.h"

#include "base/log_ratio.h"

namespace saccade {
namespace {

void logResponseRow(const float* dI, const float* I_prev, float I_eps, int width, float* __restrict dL) {
  for (int x = 0; x < width; ++x) {
    const float prev = clampTo(I_prev[x], 0, kMaxLuminance);
    const float change = clampTo(dI[x], -prev, kMaxLuminance - prev);
    const float delta = logRatio(I_eps + prev, I_eps + (prev + change), change);
    const bool finite = dI[x] - dI[x] == 0 && I_prev[x] - I_prev[x] == 0;
    dL[x] = finite ? delta : 0;
  }
}

}  // namespace

void logResponse(const IntensityChange& change, float bias, ImageF& dL) {
  for (int y = 0; y < dL.height(); ++y) {
    logResponseRow(change.dI.row(y), change.I_prev.row(y), bias, dL.width(), dL.row(y));
  }
}

}  // namespace saccade
