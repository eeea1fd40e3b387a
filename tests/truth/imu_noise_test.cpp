// Noise of the IMU against its densities.
#include "truth/imu/imu_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/hash_rng.h"
#include "base/thread_time.h"

namespace saccade {
namespace {

// Mean square of f(0), ..., f(n - 1).
template <class F>
double meanSquare(int n, const F& f) {
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += f(i) * f(i);
  return sum / n;
}

std::uint64_t keyOf(int i) {
  return mix64(static_cast<std::uint64_t>(i) + 1);
}

// The relative error of a variance from n independent samples is sqrt(2 / n): tolerances are five of them.
double tolerance(int n) {
  return 5 * std::sqrt(2.0 / n);
}

TEST(RandomWalk, StepsAreIndependentAndOfVarianceOne) {
  constexpr int kSteps = 20000;
  RandomWalk walk(7);
  const auto step = [&](int i) {
    return walk.at(static_cast<std::uint64_t>(i) + 1) - walk.at(static_cast<std::uint64_t>(i));
  };
  EXPECT_NEAR(meanSquare(kSteps, step), 1, tolerance(kSteps));
  double product = 0;
  for (int i = 0; i < kSteps; ++i) product += step(i) * step(i + 1);
  EXPECT_NEAR(product / kSteps, 0, 5 / std::sqrt(kSteps));
}

TEST(RandomWalk, ItsVarianceGrowsWithTime) {
  constexpr int kWalks = 2000;
  for (const std::uint64_t steps : {1ull, 10ull, 1000ull, 12'345'678ull}) {
    const double variance = meanSquare(kWalks, [&](int key) { return RandomWalk(keyOf(key)).at(steps); });
    EXPECT_NEAR(variance / static_cast<double>(steps), 1, tolerance(kWalks)) << steps;
  }
  EXPECT_EQ(RandomWalk(3).at(0), 0);
}

// The same bits, in order, backwards, and each from a walk of its own.
TEST(RandomWalk, AStepDoesNotDependOnWhatWasAskedBefore) {
  RandomWalk forth(11), back(11), leaping(11);
  std::vector<double> path;
  for (std::uint64_t i = 0; i < 3000; ++i) path.push_back(forth.at(i));
  for (std::uint64_t i = 3000; i-- > 0;) {
    ASSERT_EQ(back.at(i), path[i]) << i;
    leaping.at(mix64(i) >> 24);
    ASSERT_EQ(leaping.at(i), path[i]) << i;
    ASSERT_EQ(RandomWalk(11).at(i), path[i]) << i;
  }
}

// From the root each step costs 40 normal numbers, in order two. The ratio of times says so on any machine.
TEST(RandomWalk, StepsInOrderCostLittle) {
  constexpr std::uint64_t kSteps = 100'000;
  const auto seconds = [](const auto& at) {
    const auto began = threadCpuTime();
    double sum = 0;
    for (std::uint64_t i = 0; i < kSteps; ++i) sum += at(i);
    EXPECT_TRUE(std::isfinite(sum));
    return std::chrono::duration<double>(threadCpuTime() - began).count();
  };
  RandomWalk walk(5);
  EXPECT_LT(seconds([&](std::uint64_t i) { return walk.at(i); }),
            0.25 * seconds([](std::uint64_t i) { return RandomWalk(5).at(i); }));
}

TEST(ImuNoise, WhiteNoiseHasItsDensity) {
  constexpr int kSamples = 20000;
  const ImuConfig config{.rate_hz = 400, .accelerometer_noise = 0.02, .gyroscope_noise = 0.003, .seed = 5};
  ImuNoise noise(config);
  const auto at = [&](int i) { return noise.at(static_cast<std::uint64_t>(i) + 1); };
  EXPECT_NEAR(meanSquare(kSamples, [&](int i) { return at(i).force.x; }), 400 * 0.02 * 0.02,
              400 * 0.02 * 0.02 * tolerance(kSamples));
  EXPECT_NEAR(meanSquare(kSamples, [&](int i) { return at(i).rate.z; }), 400 * 0.003 * 0.003,
              400 * 0.003 * 0.003 * tolerance(kSamples));
  double product = 0;
  for (int i = 0; i < kSamples; ++i) product += at(i).force.x * at(i).force.y / (400 * 0.02 * 0.02);
  EXPECT_NEAR(product / kSamples, 0, 5 / std::sqrt(kSamples));
}

// After t seconds the variance of the bias is walk^2 t, whatever the rate.
TEST(ImuNoise, TheBiasWalksByItsDensity) {
  constexpr int kSeeds = 2000;
  for (const double rate : {100.0, 1000.0}) {
    for (const double t : {0.5, 50.0}) {
      const double variance = meanSquare(kSeeds, [&](int seed) {
        const ImuConfig config{.rate_hz = rate, .gyroscope_walk = 0.01, .seed = keyOf(seed)};
        return ImuNoise(config).at(static_cast<std::uint64_t>(rate * t)).rate.y;
      });
      EXPECT_NEAR(variance / (0.01 * 0.01 * t), 1, tolerance(kSeeds)) << rate << " Hz, " << t << " s";
    }
  }
}

TEST(ImuNoise, IsNothingWhereItIsOff) {
  const ImuReading noise = ImuNoise({.seed = 4}).at(17);
  EXPECT_EQ(noise.force, Vec3d{});
  EXPECT_EQ(noise.rate, Vec3d{});
}

}  // namespace
}  // namespace saccade
