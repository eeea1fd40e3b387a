// The common part of the complementary and the Kalman filter: predicts brightness by dL, corrects it by the
// primal.
#pragma once

#include "frame/intensity_change.h"

namespace saccade {

class PredictCorrect {
 public:
  // `bias` is I_eps.
  PredictCorrect(double bias, int width, int height);

  // L^ becomes the brightness of the same intensity by another I_eps.
  void setBias(double bias);

  // L^_t = L- + k (L^prim_t - L-), L- = L^_{t-1} + dL_t; dL becomes L^_t - L^_{t-1}. `gains(y)` points to k
  // of each pixel of row y, in [0, 1]. A primal that is NaN or Inf corrects nothing.
  template <class Gains>
  void advance(const IntensityChange& change, Gains&& gains, ImageF& dL) {
    if (!started_) start(change.I_prev);
    for (int y = 0; y < L_.height(); ++y) advanceRow(y, change.I_now.row(y), gains(y), dL.row(y));
  }

 private:
  void start(const ImageF& I_prev);
  void advanceRow(int y, const float* I_now, const float* k, float* __restrict dL);

  float I_eps_;
  float low_, high_;  // the brightness a pixel can have
  ImageF L_;          // L^
  bool started_ = false;
};

}  // namespace saccade
