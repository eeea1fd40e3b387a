#include "events/log_response.h"

namespace saccade {
namespace {

void logResponseRow(const float* dI, const float* I_prev, float I_eps, int width, float* __restrict dL) {
  for (int x = 0; x < width; ++x) dL[x] = logResponse(I_prev[x], dI[x], I_eps);
}

}  // namespace

void logResponse(const IntensityChange& change, float bias, ImageF& dL) {
  for (int y = 0; y < dL.height(); ++y) {
    logResponseRow(change.dI.row(y), change.I_prev.row(y), bias, dL.width(), dL.row(y));
  }
}

}  // namespace saccade
