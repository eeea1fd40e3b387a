// The measurements of a sensor with noise, against the formulas of the noise.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "eval/sensor/expectation.h"
#include "eval/sensor/frequency_response.h"
#include "eval/sensor/latency.h"
#include "eval/sensor/noise_rate.h"
#include "eval/sensor/threshold.h"

namespace saccade::eval {
namespace {

SensorSetup sensorWith(const NoiseConfig& noise) {
  return {{.threshold = 0.2, .threshold_off = 0.2, .bias = 1e-9, .seed = 3, .noise = noise}, 64, 64};
}

// 68 % of a normal distribution lie within a standard deviation.
TEST(NoisyThreshold, SpreadsByTheMismatch) {
  const SensorSetup setup = sensorWith({.mismatch = 0.1});
  for (const int sign : {1, -1}) {
    const auto thresholds = pixelThresholds(setup, 1, sign);
    const auto at = [&](double share) { return changeOfShare(thresholds, share, setup.pixels()); };
    EXPECT_NEAR(at(0.5), 0.2, 5 * 1.25 * 0.02 / 64);
    EXPECT_NEAR((at(0.8413) - at(0.1587)) / 2, 0.02, 0.02 * 0.08);
  }
  EXPECT_NEAR(expectedWithin(setup.config, 1, 0.22), 0.8413, 1e-4);
  EXPECT_NEAR(expectedWithin(setup.config, 1, -0.18), 0.1587, 1e-4);
}

// A photoreceptor delays both events alike, and the readout is left out.
TEST(NoisyThreshold, DoesNotDependOnBandwidthAndReadout) {
  const SensorSetup setup = sensorWith({.photoreceptor_hz = 30, .readout_hz = 1000, .readout_buffer = 0});
  const auto thresholds = pixelThresholds(setup, 1, 1);
  ASSERT_EQ(thresholds.size(), static_cast<std::size_t>(setup.pixels()));
  EXPECT_NEAR(thresholds.front(), 0.2, 0.01);
  EXPECT_NEAR(thresholds.back(), 0.2, 0.01);
}

TEST(NoisyThreshold, DeadPixelsDoNotAnswer) {
  const SensorSetup setup = sensorWith({.dead_fraction = 0.25});
  EXPECT_NEAR(shareAnswering(setup, 1, 0.6), 0.75, 5 * 0.43 / 64);
  EXPECT_NEAR(expectedAnswers(setup.config, 1, 0.6), 0.75, 1e-12);
}

// 4096 pixels see 12000 events in 3 s: 5 standard deviations are 5 %.
TEST(NoisyPicture, HasLeakAndShotNoise) {
  const SensorSetup setup = sensorWith({.reference_luminance = 2, .leak_hz = 0.5, .shot_hz = 2});
  const struct {
    double I, on_hz, off_hz;
  } cases[] = {{1e-6, 0.5 + 1, 1}, {1, 0.5 + 1 - 0.375, 1 - 0.375}, {10, 0.5 + 0.25, 0.25}};
  for (const auto& [I, on_hz, off_hz] : cases) {
    const NoiseRate rate = measureNoise(setup, I, 3), expected = expectedNoise(setup.config, I);
    EXPECT_NEAR(rate.on_hz, on_hz, 5 * std::sqrt(on_hz / 3) / 64) << I;
    EXPECT_NEAR(rate.off_hz, off_hz, 5 * std::sqrt(off_hz / 3) / 64) << I;
    EXPECT_NEAR(expected.on_hz, on_hz, 1e-5) << I;
    EXPECT_NEAR(expected.off_hz, off_hz, 1e-5) << I;
  }
}

// The level leaks by 0.8 C+ per second, from anywhere: 4096 pixels have 0.8 events per second in the mean.
TEST(NoisyPicture, HasTheLeakOfTheLevel) {
  const SensorSetup setup = sensorWith({.level_leak_hz = 0.8, .rate_spread = 0.3});
  EXPECT_NEAR(measureNoise(setup, 1, 5).on_hz, 0.8, 5 * 0.8 * 0.31 / 64);
  EXPECT_DOUBLE_EQ(expectedNoise(setup.config, 1).on_hz, 0.8);
  EXPECT_EQ(expectedNoise(setup.config, 1).off_hz, 0);
}

// C- / (C+ + C-) of the events are ON. A leak makes it more of them.
TEST(NoisyPicture, HasTheFirstPassagesOfTheModelStochastic) {
  for (const double leak : {0.0, 2.0}) {
    SensorSetup setup = sensorWith({.level_leak_hz = leak, .brownian_hz = 1});
    setup.width = setup.height = 24;
    setup.config.model = "stochastic", setup.config.threshold_off = 0.3;
    for (const double I : {1e-6, 0.5, 1.0}) {
      const NoiseRate rate = measureNoise(setup, I, 10), expected = expectedNoise(setup.config, I);
      const double all = expected.on_hz + expected.off_hz;
      EXPECT_NEAR(rate.on_hz, expected.on_hz, 5 * std::sqrt(all / 10) / 24) << I << ' ' << leak;
      EXPECT_NEAR(rate.off_hz, expected.off_hz, 5 * std::sqrt(all / 10) / 24) << I << ' ' << leak;
      if (leak == 0) {
        EXPECT_NEAR(all, std::min(10.0, 1 / I), 1e-6);
        EXPECT_NEAR(expected.on_hz / all, 0.6, 1e-9);
      }
    }
  }
}

// A dark current as bright as the scene halves a small change.
TEST(NoisyFrequencyResponse, FlattensBelowTheDarkCurrent) {
  const SensorSetup setup = sensorWith({.dark_luminance = 1});
  EXPECT_NEAR(expectedGain(setup.config, 1, 20), 0.5, 1e-6);
  EXPECT_NEAR(measureResponse(setup, 1, 0.8, 20).gain, 0.5, 0.03);
}

// At the reference luminance the photoreceptor has all of its bandwidth; in the dark, an eleventh.
TEST(NoisyFrequencyResponse, FollowsThePoles) {
  const SensorSetup one = sensorWith({.photoreceptor_hz = 200});
  const SensorSetup two = sensorWith({.photoreceptor_hz = 200, .follower_hz = 200});
  // The intensity of a larger sinusoid would move the bandwidth.
  EXPECT_NEAR(measureResponse(one, 10, 0.6, 200).gain, 1 / std::numbers::sqrt2, 0.02);
  EXPECT_NEAR(measureResponse(two, 10, 0.6, 200).gain, 0.5, 0.02);
  EXPECT_NEAR(measureResponse(one, 1e-5, 0.6, 200.0 / 11).gain, 1 / std::numbers::sqrt2, 0.02);
  EXPECT_NEAR(expectedGain(two.config, 10, 200), 0.5, 1e-6);
  EXPECT_NEAR(expectedGain(one.config, 1e-5, 200.0 / 11), 1 / std::numbers::sqrt2, 1e-3);
}

// Pixels wait for a part of the step that is uniform up to C+ + C-: t = -tau log(1 - q (C+ + C-) / dL).
TEST(NoisyLatency, IsThatOfThePole) {
  const SensorSetup setup = sensorWith({.photoreceptor_hz = 100});
  const double tau = 1 / (2 * std::numbers::pi * 100);
  const auto expected = [&](double q) { return -tau * std::log(1 - q * 0.4 / 0.6); };
  const Latency measured = measureLatency(setup, 10, 0.6);
  EXPECT_NEAR(measured.median_s, expected(0.5), 0.04 * tau);
  EXPECT_NEAR(measured.low_s, expected(0.16), 0.04 * tau);
  EXPECT_NEAR(measured.high_s, expected(0.84), 0.06 * tau);
  for (const double q : {0.16, 0.5, 0.84})
    EXPECT_NEAR(expectedLatency(setup.config, 10, 0.6, q), expected(q), 1e-9);
}

// Two equal poles have the step response 1 - (1 + t / tau) exp(-t / tau).
TEST(NoisyLatency, IsThatOfTwoPoles) {
  const SensorSetup setup = sensorWith({.photoreceptor_hz = 100, .follower_hz = 100});
  const double tau = 1 / (2 * std::numbers::pi * 100);
  const double t = expectedLatency(setup.config, 10, 0.8, 0.5) / tau;
  EXPECT_NEAR((1 + t) * std::exp(-t), 1 - 0.5 * 0.4 / 0.8, 1e-9);
  EXPECT_NEAR(measureLatency(setup, 10, 0.8).median_s, t * tau, 0.04 * tau);
}

// A rise takes longer than a fall: t = ln((exp(dL) - 1) / (exp(dL (1 - wait)) - 1)) / a.
TEST(NoisyLatency, DependsOnTheSignWithAnAsymmetry) {
  const SensorSetup setup = sensorWith({.photoreceptor_hz = 100, .asymmetry = 1});
  const double tau = 1 / (2 * std::numbers::pi * 100);
  for (const double step : {1.5, -1.5}) {
    const double t = expectedLatency(setup.config, 10, step, 0.5);
    EXPECT_NEAR(t, tau * std::log(std::expm1(step) / std::expm1(step * (1 - 0.2 / 1.5))), 1e-9);
    EXPECT_NEAR(measureLatency(setup, 10, step).median_s, t, 0.04 * tau) << step;
  }
}

}  // namespace
}  // namespace saccade::eval
