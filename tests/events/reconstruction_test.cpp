#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <random>

#include "reconstruction_run.h"

namespace saccade {
namespace {

using test::ReconstructionRun;

const SensorConfig kDirect{.reconstruction = "direct"};
const SensorConfig kComplementary{.reconstruction = "complementary"};
const SensorConfig kKalman{.reconstruction = "kalman"};

// beta = exp(-omega dt) of the default cutoff, 0.5 Hz, at 500 frames per second.
const double kBeta = std::exp(-2 * std::numbers::pi * 0.5 / 500);

TEST(Direct, LeavesEveryBitAsItIs) {
  ReconstructionRun run(kDirect);
  std::mt19937 random(3);
  std::normal_distribution<float> normal(0, 0.3f);
  for (int t = 0; t < 100; ++t) {
    const float dL = normal(random);
    EXPECT_EQ(run.step(dL, normal(random)), dL);
  }
}

TEST(Complementary, FollowsAStepOfThePrimalByItsTimeConstant) {
  ReconstructionRun run(kComplementary);
  for (int n = 1; n <= 2000; ++n) {
    run.step(0, 0.7);
    ASSERT_NEAR(run.sum, 0.7 * (1 - std::pow(kBeta, n)), 3e-4) << n;
  }
}

TEST(Complementary, DoesNotDependOnTheFrameRate) {
  SensorConfig config = kComplementary;
  config.reconstruction_cutoff_hz = 5;
  for (const double rate_hz : {50, 500, 5000}) {
    ReconstructionRun run(config, rate_hz);
    for (int n = 0; n < 0.2 * rate_hz; ++n) run.step(0, 0.7);
    EXPECT_NEAR(run.sum, 0.7 * (1 - std::exp(-2 * std::numbers::pi * 5 * 0.2)), 1e-4) << rate_hz;
  }
}

TEST(Drift, DirectDriftsWithoutBoundAndComplementaryByItsBound) {
  const double b = 1e-3;
  ReconstructionRun direct(kDirect), complementary(kComplementary);
  for (int n = 1; n <= 3000; ++n) {
    direct.step(b, 0);
    complementary.step(b, 0);
    // e_n = beta (e_{n-1} + b)
    ASSERT_NEAR(complementary.sum, b * kBeta * (1 - std::pow(kBeta, n)) / (1 - kBeta), 3e-4) << n;
    ASSERT_LT(complementary.sum, b / (1 - kBeta));
  }
  EXPECT_NEAR(direct.sum, 3, 1e-4);
}

TEST(Drift, KalmanStaysWithinTheBoundOfItsSteadyGain) {
  const double b = 1e-3, var_dL = 1e-6, var_primal = 1e-3;
  const double Q = var_dL, R = (2 - 0.1) / 0.1 * var_primal;
  const double P =
      (Q + std::sqrt(Q * Q + 4 * Q * R)) / 2;             // P^2 - Q P - Q R = 0: the scalar Riccati equation
  const double k = P / (P + R), bound = b * (1 - k) / k;  // e = (1 - k) (e + b)
  ReconstructionRun run(kKalman);
  run.setVariances(var_dL, var_primal);
  for (int n = 1; n <= 5000; ++n) run.step(b, 0);
  EXPECT_NEAR(run.sum, bound, 2e-3 * bound);
  for (int n = 1; n <= 10; ++n) EXPECT_LT(std::abs(run.step(b, 0)), 2e-6) << "it has settled";
}

// A jump that difference and primal agree on passes whole; one that the primal sees late, but for the gain.
TEST(HighFrequencies, PassUnchangedToFirstOrder) {
  for (const SensorConfig& config : {kComplementary, kKalman}) {
    ReconstructionRun agreed(config), late(config);
    for (ReconstructionRun* run : {&agreed, &late}) {
      run->setVariances(1e-6, 1e-3);
      for (int n = 0; n < 100; ++n) run->step(0, 0);
    }
    EXPECT_NEAR(agreed.step(0.5, 0.5), 0.5, 1e-6) << config.reconstruction;
    EXPECT_NEAR(late.step(0.5, 0), 0.5, 0.01 * 0.5) << config.reconstruction;
  }
}

// Noise of an accumulated primal, correlated as alpha 0.1 leaves it, through a complementary filter.
TEST(StandingScene, ComplementaryLetsThroughTheNoiseThatItsHeaderSays) {
  const double s = 0.1, rho = 0.9, k = 1 - kBeta;
  const double expected = s * s * k / (2 - k) * (1 + kBeta * rho) / (1 - kBeta * rho);
  EXPECT_NEAR(std::sqrt(expected) / s, 0.24, 0.005);
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  ReconstructionRun run(kComplementary);
  double noise = 0, squares = 0;
  const int kFrames = 400'000;
  for (int t = 0; t < kFrames; ++t) {
    noise = rho * noise + std::sqrt(1 - rho * rho) * s * normal(random);
    run.step(0, noise);
    squares += run.sum * run.sum;
  }
  // L^ forgets in 1 / k frames: kFrames k / 2 free samples tell its variance to sqrt(2 / n), 4 %. Five of
  // these.
  EXPECT_NEAR(squares / kFrames, expected, 5 * std::sqrt(4 / (kFrames * k)) * expected);
}

TEST(StandingScene, KalmanChangesByExactlyNothing) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, 0.3);
  ReconstructionRun run(kKalman);
  run.setVariances(0, 0.09);
  for (int t = 0; t < 100; ++t) EXPECT_EQ(run.step(0, normal(random)), 0);
}

TEST(StandingScene, KalmanFallsSilentWhereMotionEnds) {
  ReconstructionRun run(kKalman);
  run.setVariances(1e-4, 1e-3);
  for (int t = 0; t < 200; ++t) run.step(0, 0);
  run.setVariances(0, 1e-3);
  for (int t = 0; t < 100; ++t) EXPECT_EQ(run.step(0, 0.2), 0);
}

TEST(Degenerate, AVarianceOfNothingOrInfinityBreaksNothing) {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
  const double values[] = {0, 1e-3, inf, nan, -1, 1e38};
  for (const double of_dL : values) {
    for (const double of_primal : values) {
      ReconstructionRun run(kKalman);
      run.setVariances(of_dL, of_primal);
      for (int t = 0; t < 50; ++t)
        ASSERT_TRUE(std::isfinite(run.step(0.1, 0.5))) << of_dL << " " << of_primal;
      ASSERT_TRUE(std::abs(run.sum) < 50) << "brightness stays within what a pixel can have";
      run.setVariances(1e-4, 1e-4);
      for (int t = 0; t < 2000; ++t) run.step(0, 0.5);
      EXPECT_NEAR(run.sum, 0.5, 1e-3) << "and recovers from " << of_dL << " " << of_primal;
    }
  }
}

TEST(Degenerate, AMethodWithoutVariancesIsBelieved) {
  ReconstructionRun run(kKalman);
  for (int t = 0; t < 10; ++t) EXPECT_NEAR(run.step(0.1, 3), 0.1, 1e-6);
  for (int t = 0; t < 100; ++t) run.step(-0.1, 3);
  EXPECT_NEAR(run.sum, std::log(run.bias), 1e-5) << "but nothing is darker than black";
}

TEST(Degenerate, APrimalThatIsNoNumberCorrectsNothing) {
  const float values[] = {std::nanf(""), std::numeric_limits<float>::infinity()};
  for (const SensorConfig& config : {kComplementary, kKalman}) {
    for (const float value : values) {
      ReconstructionRun run(config);
      run.setVariances(1e-4, 1e-3);
      run.step(0, 0.5);
      run.change.I_now.at(0, 0) = value;
      run.dL.at(0, 0) = 0.25f;
      run.reconstruction->reconstruct(run.change, run.dL);
      EXPECT_NEAR(run.dL.at(0, 0), 0.25, 1e-6);
      EXPECT_TRUE(std::isfinite(run.step(0, 0.5)));
    }
  }
}

}  // namespace
}  // namespace saccade
