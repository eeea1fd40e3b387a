// The spread of thresholds, from the events of a steady ramp.
#include <gtest/gtest.h>

#include <cmath>

#include "model_run.h"

namespace saccade {
namespace {

constexpr int kSide = 64;
constexpr double kC = 0.2;

// A ramp of 400 C gives a pixel 400 C / C+ events, but for the phases that are random.
std::vector<double> thresholdsOf(const SensorConfig& config, float sign) {
  test::ModelRun run(config, kSide, kSide);
  std::vector<double> counts(kSide * kSide);
  for (int i = 0; i < 20; ++i) {
    for (const Event& e : run.step(sign * static_cast<float>(20 * kC))) ++counts[e.y * kSide + e.x];
  }
  for (double& count : counts) count = 400 * kC / count;
  return counts;
}

double meanOf(const std::vector<double>& v) {
  double sum = 0;
  for (const double a : v) sum += a;
  return sum / static_cast<double>(v.size());
}

double covariance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - meanOf(a)) * (b[i] - meanOf(b));
  return sum / static_cast<double>(a.size());
}

class Mismatch : public testing::TestWithParam<std::string> {
 protected:
  SensorConfig config(double mismatch) const {
    SensorConfig config{.threshold = kC,
                        .threshold_off = kC,
                        .model = GetParam(),
                        .max_events_per_pixel_frame = 1000,
                        .seed = 5};
    config.noise.mismatch = mismatch;
    return config;
  }
};

TEST_P(Mismatch, ThresholdsHaveItsStandardDeviationAndOnIsIndependentOfOff) {
  for (const double mismatch : {0.03, 0.15}) {
    const auto on = thresholdsOf(config(mismatch), 1), off = thresholdsOf(config(mismatch), -1);
    const double n = static_cast<double>(on.size()), sigma = mismatch * kC;
    for (const auto& C : {on, off}) {
      EXPECT_NEAR(meanOf(C), kC, 5 * sigma / std::sqrt(n) + 0.005 * kC);
      EXPECT_NEAR(std::sqrt(covariance(C, C)), sigma, 5 * sigma / std::sqrt(2 * n) + 0.004 * kC);
    }
    EXPECT_NEAR(covariance(on, off) / (sigma * sigma), 0, 5 / std::sqrt(n));
  }
}

TEST_P(Mismatch, EveryThresholdStaysPositive) {
  for (const double C : thresholdsOf(config(0.5), 1)) EXPECT_GT(C, 0.09 * kC);
}

INSTANTIATE_TEST_SUITE_P(Models, Mismatch, testing::Values("accumulating", "probabilistic"),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace saccade
