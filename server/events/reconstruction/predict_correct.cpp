#include "events/reconstruction/predict_correct.h"

#include <cmath>

#include "base/log_ratio.h"

namespace saccade {

PredictCorrect::PredictCorrect(double bias, int width, int height)
    : I_eps_(static_cast<float>(bias)),
      low_(logBrightness(0, I_eps_)),
      high_(logBrightness(kMaxLuminance, I_eps_)),
      L_(width, height) {}

void PredictCorrect::setBias(double bias) {
  const float before = I_eps_;
  I_eps_ = static_cast<float>(bias);
  low_ = logBrightness(0, I_eps_);
  high_ = logBrightness(kMaxLuminance, I_eps_);
  for (int y = 0; y < L_.height(); ++y) {
    float* L = L_.row(y);
    for (int x = 0; x < L_.width(); ++x) L[x] = logBrightness(std::exp(L[x]) - before, I_eps_);
  }
}

void PredictCorrect::start(const ImageF& I_prev) {
  for (int y = 0; y < L_.height(); ++y) {
    const float* I = I_prev.row(y);
    float* L = L_.row(y);
    for (int x = 0; x < L_.width(); ++x) L[x] = finiteLogBrightness(I[x], I_eps_);
  }
  started_ = true;
}

void PredictCorrect::advanceRow(int y, const float* I_now, const float* k, float* __restrict dL) {
  float* __restrict L = L_.row(y);
  for (int x = 0; x < L_.width(); ++x) {
    const float predicted = clampTo(L[x] + dL[x], low_, high_);
    const float correction = k[x] * (logBrightness(I_now[x], I_eps_) - predicted);
    const float corrected = predicted + (I_now[x] - I_now[x] == 0 ? correction : 0);
    // The difference of the stored values: rounding of the sum must not become a drift.
    dL[x] = corrected - L[x];
    L[x] = corrected;
  }
}

}  // namespace saccade
