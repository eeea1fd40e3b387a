// Noise of the IMU against its densities.
#include "truth/imu/imu_noise.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/hash_rng.h"

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
  const auto step = [](int i) {
    return randomWalk(7, static_cast<std::uint64_t>(i) + 1) - randomWalk(7, static_cast<std::uint64_t>(i));
  };
  EXPECT_NEAR(meanSquare(kSteps, step), 1, tolerance(kSteps));
  double product = 0;
  for (int i = 0; i < kSteps; ++i) product += step(i) * step(i + 1);
  EXPECT_NEAR(product / kSteps, 0, 5 / std::sqrt(kSteps));
}

TEST(RandomWalk, ItsVarianceGrowsWithTime) {
  constexpr int kWalks = 2000;
  for (const std::uint64_t steps : {1ull, 10ull, 1000ull, 12'345'678ull}) {
    const double variance = meanSquare(kWalks, [&](int key) { return randomWalk(keyOf(key), steps); });
    EXPECT_NEAR(variance / static_cast<double>(steps), 1, tolerance(kWalks)) << steps;
  }
  EXPECT_EQ(randomWalk(3, 0), 0);
}

TEST(ImuNoise, WhiteNoiseHasItsDensity) {
  constexpr int kSamples = 20000;
  const ImuConfig config{.rate_hz = 400, .accelerometer_noise = 0.02, .gyroscope_noise = 0.003, .seed = 5};
  const auto at = [&](int i) { return imuNoise(config, static_cast<std::uint64_t>(i) + 1); };
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
        return imuNoise(config, static_cast<std::uint64_t>(rate * t)).rate.y;
      });
      EXPECT_NEAR(variance / (0.01 * 0.01 * t), 1, tolerance(kSeeds)) << rate << " Hz, " << t << " s";
    }
  }
}

TEST(ImuNoise, IsNothingWhereItIsOff) {
  const ImuReading noise = imuNoise({.seed = 4}, 17);
  EXPECT_EQ(noise.force, Vec3d{});
  EXPECT_EQ(noise.rate, Vec3d{});
}

}  // namespace
}  // namespace saccade
