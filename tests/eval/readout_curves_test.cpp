// The measurements of jitter and readout, against their formulas.
#include <gtest/gtest.h>

#include <cmath>

#include "eval/sensor/readout.h"
#include "eval/sensor/time_error.h"

namespace saccade::eval {
namespace {

SensorSetup sensorWith(const NoiseConfig& noise) {
  return {{.threshold = 0.2, .threshold_off = 0.3, .bias = 1e-9, .seed = 3, .noise = noise}, 64, 64};
}

// Far from the ends of an interval the error is that of the jitter. Two uniform times are T / sqrt 6 apart.
TEST(TimeErrorExpected, HasBothLimits) {
  const NoiseConfig noise{.jitter_s = 1e-5};
  EXPECT_NEAR(expectedTimeError(noise, TimeNs(1'000'000'000)), 1e-5, 1e-8);
  EXPECT_NEAR(expectedTimeError({.jitter_s = 0.1}, TimeNs(1'000'000)), 1e-3 / std::sqrt(6), 1e-8);
  EXPECT_EQ(expectedTimeError({}, TimeNs(1'000'000'000)), 0);
}

// 4096 events: five standard deviations are 5.5 %. An interval as long as the jitter is between both limits.
TEST(TimeError, IsThatOfTheJitter) {
  const NoiseConfig noise{.mismatch = 0.1, .photoreceptor_hz = 200, .leak_hz = 5, .jitter_s = 1e-3};
  for (const std::int64_t ns : {100'000'000, 10'000'000, 2'000'000, 1'000'000, 200'000}) {
    const TimeNs interval(ns);
    const double expected = expectedTimeError(noise, interval);
    EXPECT_NEAR(measureTimeError(sensorWith(noise), interval) / expected, 1, 0.055) << ns;
  }
  EXPECT_EQ(measureTimeError(sensorWith({}), TimeNs(1'000'000)), 0);
  EXPECT_TRUE(std::isnan(measureTimeError(sensorWith({.dead_fraction = 1}), TimeNs(1'000'000))));
}

// No places, one place: the chain has one state, and two [Kleinrock 1975].
TEST(Queue, WithFewPlacesHasItsClosedForms) {
  for (const double rho : {0.1, 0.9, 1.0, 7.0}) {
    const QueueLoad none = expectedQueue(rho * 50, 50, 0);
    EXPECT_NEAR(none.lost, rho / (1 + rho), 1e-12);
    EXPECT_NEAR(none.wait_s, 0, 1e-12);
    const QueueLoad one = expectedQueue(rho * 50, 50, 1);
    EXPECT_NEAR(one.lost, 1 - 1 / (std::exp(-rho) + rho), 1e-12);
    EXPECT_NEAR(one.wait_s, one.lost / (rho * 50 * (1 - one.lost)), 1e-12);
  }
}

// Without losses the wait is rho / (2 mu (1 - rho)) [Pollaczek 1930]. Far above the throughput the server
// never rests, and all places are taken.
TEST(Queue, WithManyPlacesHasItsLimits) {
  for (const double rho : {0.01, 0.5, 0.9}) {
    const QueueLoad load = expectedQueue(rho * 1e6, 1e6, 1024);
    EXPECT_NEAR(load.lost, 0, 1e-12);
    EXPECT_NEAR(load.wait_s / (rho / (2e6 * (1 - rho))), 1, 1e-9);
  }
  const QueueLoad full = expectedQueue(4e6, 1e6, 1024);
  EXPECT_NEAR(full.lost, 0.75, 1e-9);
  EXPECT_NEAR(full.wait_s, 1024e-6, 1e-6);
}

TEST(Readout, DeliversLosesAndWaitsAsAQueueDoes) {
  for (const double places : {0.0, 3.0, 100.0}) {
    const NoiseConfig noise{.readout_hz = 1000, .readout_buffer = places};
    for (const double hz : {200.0, 700.0, 1500.0, 5000.0}) {
      const ReadoutLoad measured = measureReadout(noise, hz), expected = expectedReadout(noise, hz);
      EXPECT_NEAR(measured.delivered_hz / expected.delivered_hz, 1, 0.01) << places << " " << hz;
      EXPECT_NEAR(measured.queue.lost, expected.queue.lost, 0.005) << places << " " << hz;
      EXPECT_NEAR(measured.queue.wait_s, expected.queue.wait_s, 0.02 * expected.queue.wait_s + 1e-6)
          << places << " " << hz;
    }
  }
}

TEST(Readout, TakesAnyNumberWhereItIsOff) {
  const ReadoutLoad measured = measureReadout({}, 1e6), expected = expectedReadout({}, 1e6);
  EXPECT_NEAR(measured.delivered_hz / 1e6, 1, 0.01);
  EXPECT_EQ(measured.queue.lost, 0);
  EXPECT_EQ(measured.queue.wait_s, 0);
  EXPECT_EQ(expected.delivered_hz, 1e6);
  EXPECT_EQ(expected.queue.lost, 0);
}

}  // namespace
}  // namespace saccade::eval
