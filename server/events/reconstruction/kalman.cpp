// Kalman filter [WNSM21] in frame form: the gain of each pixel follows from the variances of dL and L^prim.
//
//   k = P / (P + R),  P = (Q + sqrt(Q^2 + 4 Q R)) / 2
//   Q = var_dI / (I_eps + I_prev)^2,  R = (2 - alpha) / alpha var_I_prev / (I_eps + I_prev)^2
//
// P is the variance of the prediction for constant Q and R: the fixed point of P = (1 - k) P + Q. This is
// ours: the P of WNSM21 follows Q and R frame by frame. Without a change there is thus nothing to
// correct, at once: a camera that stops makes no more events. Both variances are relative: to first order
// they are those of a logarithm. The variance of I_now is replaced by var_I_prev: the relative noise is
// much the same.
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/log_ratio.h"
#include "events/reconstruction/predict_correct.h"
#include "events/reconstruction/reconstructions.h"

namespace saccade {
namespace {

// The filter assumes that the errors of successive primals are independent. Those of an accumulated primal
// have the correlation (1 - alpha)^n between frames n apart. A mean over many frames then has 1 + 2 sum (1 -
// alpha)^n = (2 - alpha) / alpha times the variance of independent ones. A sensor does not know the method's
// alpha; this is the default of all methods that accumulate. With half of it R is too small by 2, and k too
// large by sqrt 2.
//
// The errors of an accumulated dI are correlated, too. Inflating Q as well, which equals inflating neither,
// would give L^ the least error. Inflating R alone gives the change of L^ the least noise, and the change
// makes events.
constexpr float kPrimalAlpha = 0.1f;
constexpr float kInflation = (2 - kPrimalAlpha) / kPrimalAlpha;

constexpr float kMaxVariance =
    1e12f;  // log brightness spans less than 100: any larger variance acts the same

float clampVariance(float v) {
  return v > 0 ? std::min(v, kMaxVariance) : 0;  // NaN is 0
}

class Kalman final : public Reconstruction {
 public:
  Kalman(const SensorConfig& config, int width, int height)
      : I_eps_(static_cast<float>(config.bias)),
        brightness_(config.bias, width, height),
        gains_(static_cast<std::size_t>(width)) {}

  void reconstruct(const IntensityChange& change, ImageF& dL) override {
    brightness_.advance(
        change, [&](int y) { return computeGains(change, y); }, dL);
  }

  void setBias(double bias) override {
    I_eps_ = static_cast<float>(bias);
    brightness_.setBias(bias);
  }

 private:
  // Where the method knows no variance of the primal (0), there is no correction.
  const float* computeGains(const IntensityChange& change, int y) {
    const float *I_prev = change.I_prev.row(y), *var_dI = change.var_dI.row(y),
                *var_I = change.var_I_prev.row(y);
    float* __restrict k = gains_.data();
    for (int x = 0; x < change.dI.width(); ++x) {
      const float response = I_eps_ + clampTo(I_prev[x], 0, kMaxLuminance);
      const float scale = 1 / (response * response);
      const float Q = clampVariance(scale * var_dI[x]), R = kInflation * clampVariance(scale * var_I[x]);
      const float predicted = (Q + std::sqrt(Q * (Q + 4 * R))) / 2;
      k[x] = R > 0 ? predicted / (predicted + R) : 0;
    }
    return k;
  }

  float I_eps_;
  PredictCorrect brightness_;
  std::vector<float> gains_;  // of a row
};

}  // namespace

std::unique_ptr<Reconstruction> makeKalman(const SensorConfig& config, int width, int height) {
  return std::make_unique<Kalman>(config, width, height);
}

}  // namespace saccade
