#include "eval/figures/reconstruction_score.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "eval/changes.h"

namespace saccade::eval {
namespace {

constexpr double kBias = 1e-3, kC = 0.2;
constexpr int kFrames = 64, kSide = 8;
const SensorConfig kDirect{.threshold = kC, .threshold_off = kC, .bias = kBias, .reconstruction = "direct"};

std::vector<IntensityChange> frames(double dL) {
  return test::frames(kFrames, kSide, kSide, kBias, [=](int, int, int) { return dL; });
}

TEST(ReconstructionScore, IsZeroForTheTruthItself) {
  const auto truth = frames(0.03);
  const ReconstructionScore s = scoreReconstruction(test::sequence(truth), test::sequence(truth), kDirect);
  for (const double figure :
       {s.false_events, s.missed_events, s.count_error, s.voxel_error, s.drift, s.offset})
    EXPECT_EQ(figure, 0);
  EXPECT_NEAR(s.high_rms, 0, 1e-9);
}

TEST(ReconstructionScore, SeesASteadyErrorAsDrift) {
  const auto run = frames(0.04), truth = frames(0.03);
  const ReconstructionScore s = scoreReconstruction(test::sequence(run), test::sequence(truth), kDirect);
  EXPECT_NEAR(s.false_events, 0.01 / kC, 1e-5);
  EXPECT_EQ(s.missed_events, 0);
  EXPECT_NEAR(s.drift, 0.01 * kFrames, 1e-5);
  EXPECT_NEAR(s.high_rms, 0, 1e-6);
  // There are 12.8 events instead of 9.6, with the same phases.
  EXPECT_NEAR(s.count_error, 0.01 / 0.03, 0.03);
}

// A start with an error of log 2 is an offset, and no drift.
TEST(ReconstructionScore, KnowsDriftFromOffset) {
  auto run = frames(0);
  for (IntensityChange& c : run) c.I_prev.fill(static_cast<float>(2 + kBias)), c.I_now.fill(2);
  const auto truth = frames(0);
  const ReconstructionScore s = scoreReconstruction(test::sequence(run), test::sequence(truth), kDirect);
  EXPECT_EQ(s.drift, 0);
  EXPECT_NEAR(s.offset, std::log(2), 1e-6);
}

// An error at a fast and at a slow frequency. The rms of the fast one counts.
TEST(ReconstructionScore, HearsHighFrequenciesOnly) {
  const auto truth = frames(0);
  for (const double cycles : {24.0, 8.0}) {  // of 64 frames; a quarter of the rate is 16
    const auto run = test::frames(kFrames, kSide, kSide, kBias, [=](int f, int, int) {
      return 0.02 * std::cos(2 * std::numbers::pi * cycles * f / kFrames);
    });
    const ReconstructionScore s = scoreReconstruction(test::sequence(run), test::sequence(truth), kDirect);
    EXPECT_NEAR(s.high_rms, cycles > 16 ? 0.02 / std::sqrt(2) : 0, 1e-6);
  }
}

TEST(ReconstructionScore, MeasuresWhatTheConfigurationAsksFor) {
  const auto run = frames(0.01), truth = frames(0);
  SensorConfig complementary = kDirect;
  complementary.reconstruction = "complementary";
  complementary.reconstruction_cutoff_hz = 20;
  const double k = 1 - std::exp(-2 * std::numbers::pi * 20 / test::kFrameRateHz);
  const ReconstructionScore s =
      scoreReconstruction(test::sequence(run), test::sequence(truth), complementary);
  EXPECT_NEAR(s.drift, 0.01 * (1 - k) / k, 1e-5);  // the primal holds it there
}

}  // namespace
}  // namespace saccade::eval
