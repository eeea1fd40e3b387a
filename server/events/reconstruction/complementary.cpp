// Complementary filter [SBM18] in frame form: takes high frequencies from dL and low ones from the primal.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "events/reconstruction/predict_correct.h"
#include "events/reconstruction/reconstructions.h"

namespace saccade {
namespace {

class Complementary final : public Reconstruction {
 public:
  Complementary(const SensorConfig& config, int width, int height)
      : omega_(2 * std::numbers::pi * config.reconstruction_cutoff_hz),
        brightness_(config.bias, width, height),
        gains_(static_cast<std::size_t>(width)) {}

  void reconstruct(const IntensityChange& change, ImageF& dL) override {
    const double k = -std::expm1(-omega_ * seconds(change.t1 - change.t0));
    std::fill(gains_.begin(), gains_.end(), static_cast<float>(k));
    brightness_.advance(
        change, [&](int) { return gains_.data(); }, dL);
  }

  void setBias(double bias) override { brightness_.setBias(bias); }

 private:
  double omega_;  // rad/s
  PredictCorrect brightness_;
  std::vector<float> gains_;  // of a row
};

}  // namespace

std::unique_ptr<Reconstruction> makeComplementary(const SensorConfig& config, int width, int height) {
  return std::make_unique<Complementary>(config, width, height);
}

}  // namespace saccade
