// The measurements of a sensor without noise, against their formulas.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "eval/sensor/expectation.h"
#include "eval/sensor/frequency_response.h"
#include "eval/sensor/latency.h"
#include "eval/sensor/noise_rate.h"
#include "eval/sensor/threshold.h"

namespace saccade::eval {
namespace {

const SensorSetup kPlain{{.threshold = 0.2, .threshold_off = 0.3, .bias = 1e-9, .seed = 5}, 64, 64};
// Five standard deviations of a share of 4096 pixels.
const double kShare = 5 * 0.5 / std::sqrt(kPlain.pixels());

TEST(Stimuli, SineReachesItsExtremesAndKeepsItsPeriod) {
  for (const double hz : {0.5, 50.0, 9000.0}) {
    const Sine sine = sineOf(2, 0.4, hz);
    EXPECT_NEAR(seconds(sine.period) * hz, 1, 0.15);
    double low = 2, high = 2;
    for (const StimulusFrame& f : sine.frames) {
      low = std::min(low, f.I), high = std::max(high, f.I);
      EXPECT_EQ(f.t % kEventTimeUnit, TimeNs(0));
    }
    EXPECT_NEAR(std::log(high / 2), 0.4, 1e-12);
    EXPECT_NEAR(std::log(low / 2), -0.4, 1e-12);
    EXPECT_EQ(sine.frames.back().t - sine.settled, sine.measured_cycles * sine.period);
  }
}

TEST(Stimuli, StepChangesWithinAMicrosecond) {
  const Stimulus step = stepOf(2, -0.7, TimeNs(1'000'000), TimeNs(1000));
  const auto after = std::find_if(step.begin(), step.end(), [](const auto& f) { return f.t > kStepTime; });
  EXPECT_EQ(after->t, kStepTime + kEventTimeUnit);
  EXPECT_NEAR(std::log(after->I / 2), -0.7, 1e-12);
  EXPECT_EQ(std::prev(after)->t, kStepTime);
  EXPECT_EQ(std::prev(after)->I, 2);
}

// |dL| / (C+ + C-).
TEST(Threshold, AnswersRiseLinearlyAtAnyLevel) {
  for (const double step : {-0.6, -0.4, -0.05, 0.05, 0.25, 0.49, 0.6}) {
    const double share = std::min(1.0, std::abs(step) / (0.2 + 0.3));
    EXPECT_NEAR(shareAnswering(kPlain, 1, step), share, share == 1 ? 0 : kShare) << step;
    EXPECT_NEAR(expectedAnswers(kPlain.config, 1, step), share, 1e-6) << step;
  }
}

TEST(Threshold, IsThatOfTheSensorAfterAnEvent) {
  for (const int sign : {1, -1}) {
    const auto thresholds = pixelThresholds(kPlain, 1, sign);
    ASSERT_EQ(thresholds.size(), static_cast<std::size_t>(kPlain.pixels()));
    const double C = sign > 0 ? 0.2 : 0.3;
    EXPECT_NEAR(thresholds.front(), C, 1e-4);
    EXPECT_NEAR(thresholds.back(), C, 1e-4);
  }
}

// The refractory period belongs to no threshold.
TEST(Threshold, LeavesOutTheRefractoryPeriod) {
  SensorSetup setup = kPlain;
  setup.config.refractory = TimeNs(5'000'000);
  const auto thresholds = pixelThresholds(setup, 1, 1);
  ASSERT_EQ(thresholds.size(), static_cast<std::size_t>(setup.pixels()));
  EXPECT_NEAR(thresholds.front(), 0.2, 1e-4);
  EXPECT_NEAR(thresholds.back(), 0.2, 1e-4);
}

TEST(Threshold, SharesAndChangesAreInverse) {
  const std::vector<double> thresholds{0.1, 0.2, 0.3};
  EXPECT_EQ(shareWithin(thresholds, 0.2, 4), 0.5);
  EXPECT_EQ(changeOfShare(thresholds, 0.5, 4), 0.2);
  EXPECT_TRUE(std::isnan(changeOfShare(thresholds, 1, 4)));
}

TEST(Noise, IsZeroWithoutNoise) {
  const NoiseRate rate = measureNoise(kPlain, 0.1, 1);
  EXPECT_EQ(rate.on_hz, 0);
  EXPECT_EQ(rate.off_hz, 0);
}

// C (N + 1) = 2 a for equal thresholds, where 2 a is a multiple of C.
TEST(FrequencyResponse, CountsTheThresholdsOfASwing) {
  SensorSetup setup = kPlain;
  setup.config.threshold_off = 0.2;
  const FrequencyPoint p = measureResponse(setup, 1, 0.4, 100);
  EXPECT_NEAR(p.on_events, 2 * 0.4 / 0.2 - 1, 0.01);
  EXPECT_NEAR(p.off_events, 2 * 0.4 / 0.2 - 1, 0.01);
  EXPECT_NEAR(p.gain, 1, 0.005);
}

// Any amplitude; unequal thresholds; a pixel as dark as its bias, whose brightness swings half as far.
TEST(FrequencyResponse, TellsTheAmplitude) {
  SensorSetup equal = kPlain;
  equal.config.threshold_off = 0.2;
  for (const double amplitude : {0.5, 0.63, 1.1}) {
    EXPECT_NEAR(measureResponse(equal, 1, amplitude, 20).gain, 1, 0.01) << amplitude;
    EXPECT_NEAR(measureResponse(kPlain, 1, amplitude, 20).gain, 1, (0.2 + 0.3) / 4 / amplitude) << amplitude;
  }
  SensorSetup dark = equal;
  dark.config.bias = 1;
  EXPECT_NEAR(expectedGain(dark.config, 1, 20), 0.5, 1e-9);
  EXPECT_NEAR(measureResponse(dark, 1, 0.4, 20).gain, 0.5, 0.02);
}

TEST(FrequencyResponse, IsZeroBelowTheThreshold) {
  EXPECT_EQ(measureResponse(kPlain, 1, 0.05, 20).gain, 0);
}

// With a slope of -1 in logarithms the gain falls by sqrt 2 where the frequency rises by it.
TEST(FrequencyResponse, FindsTheHalfPower) {
  const std::vector<FrequencyPoint> points{
      {1, 0, 0, 0.8}, {10, 0, 0, 0.8}, {100, 0, 0, 0.08}, {1000, 0, 0, 0}};
  EXPECT_NEAR(halfPowerFrequency(points), 10 * std::sqrt(2), 1e-9);
  EXPECT_TRUE(std::isnan(halfPowerFrequency({points[0], points[1]})));
}

TEST(LatencyOfAStep, IsZeroWithoutLowPass) {
  const Latency latency = measureLatency(kPlain, 1, 0.75);
  EXPECT_EQ(latency.median_s, 0);
  EXPECT_EQ(latency.high_s, 0);
  EXPECT_EQ(latency.answered, 1);
}

TEST(LatencyOfAStep, IsUnknownWhereNoPixelAnswers) {
  EXPECT_TRUE(std::isnan(measureLatency(kPlain, 1e-17, 0.75).median_s));
}

}  // namespace
}  // namespace saccade::eval
