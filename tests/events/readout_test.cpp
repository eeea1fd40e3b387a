// Dead pixels, jitter and the arbiter against their formulas.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "events/noise/arbiter.h"
#include "events/noise/dead_pixels.h"
#include "events/noise/jitter.h"

namespace saccade {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

// A Poisson process of `hz` over an interval.
Events poisson(double hz, const Interval& interval, std::mt19937_64& random) {
  std::exponential_distribution<double> gap(hz / 1e9);
  Events events;
  for (auto t = static_cast<double>(interval.t0.count()) + gap(random);
       t < static_cast<double>(interval.t1.count()); t += gap(random)) {
    events.push_back({static_cast<std::int64_t>(t) / 1000 * 1000, 0, 0, 1});
  }
  return events;
}

TEST(DeadPixels, AShareOfThePixelsSendsNothing) {
  constexpr int kSide = 200;
  Events events;
  for (std::uint16_t y = 0; y < kSide; ++y)
    for (std::uint16_t x = 0; x < kSide; ++x) events.push_back({0, x, y, 1});
  const DeadPixels dead(0.1, 7, kSide, kSide);
  dead.remove(events);
  const double pixels = kSide * kSide;
  EXPECT_NEAR(static_cast<double>(events.size()), 0.9 * pixels, 5 * std::sqrt(0.1 * 0.9 * pixels));
  const Events left = events;
  dead.remove(events);
  EXPECT_EQ(events, left);
}

TEST(Jitter, HasItsStandardDeviationAndNoBias) {
  constexpr int kEvents = 40'000;
  constexpr double kSigma = 50e-6;
  Events events(kEvents, Event{5'000'000, 0, 0, 1});
  Jitter(kSigma, 1).move(events, {TimeNs(0), TimeNs(10'000'000), 4});
  double sum = 0, squares = 0;
  for (const Event& e : events) {
    const double error = 1e-9 * static_cast<double>(e.t_ns - 5'000'000);
    sum += error, squares += error * error;
  }
  EXPECT_NEAR(sum / kEvents, 0, 5 * kSigma / std::sqrt(kEvents));
  EXPECT_NEAR(std::sqrt(squares / kEvents), kSigma, 5 * kSigma / std::sqrt(2.0 * kEvents));
}

TEST(Jitter, KeepsEventsInTheirIntervalAndUniformOnesUniform) {
  const Interval interval{TimeNs(3'000'000), TimeNs(5'000'000), 2};
  for (const double sigma : {1e-4, 1e-3, 1.0}) {
    Events events;
    for (std::int64_t t = 3'000'000; t < 5'000'000; t += 1000)
      for (std::uint16_t i = 0; i < 16; ++i) events.push_back({t, i, 0, 1});
    Jitter(sigma, 1).move(events, interval);
    std::vector<double> tenths(10);
    for (const Event& e : events) {
      ASSERT_TRUE(e.t_ns >= 3'000'000 && e.t_ns < 5'000'000 && e.t_ns % 1000 == 0);
      ++tenths[(e.t_ns - 3'000'000) / 200'000];
    }
    for (const double count : tenths) EXPECT_NEAR(count, 3200, 5 * std::sqrt(3200)) << sigma;
  }
}

TEST(Arbiter, BelowItsThroughputKeepsEveryEventAndTime) {
  Arbiter arbiter(1e6, 0);
  Events events, expected;
  for (int i = 0; i < 1000; ++i) events.push_back({i * 1000, static_cast<std::uint16_t>(i), 0, 1});
  expected = events;
  EXPECT_EQ(arbiter.pass(events, {TimeNs(0), TimeNs(1'000'000), 1}), 0u);
  EXPECT_EQ(events, expected);
}

TEST(Arbiter, AboveItSendsAtItsThroughputAndCountsTheRest) {
  constexpr double kHz = 1e5;
  Arbiter arbiter(kHz, 50);
  std::mt19937_64 random(1);
  std::uint64_t in = 0, out = 0, lost = 0;
  std::int64_t last = 0;
  for (FrameIndex i = 1; i <= 200; ++i) {
    const Interval interval{TimeNs((i - 1) * 5'000'000), TimeNs(i * 5'000'000), i};
    Events events = poisson(4 * kHz, interval, random);
    in += events.size();
    lost += arbiter.pass(events, interval);
    out += events.size();
    for (const Event& e : events) {
      EXPECT_GE(e.t_ns - last, i == 1 ? 0 : 9'000) << "one event in 10 us, but for rounding";
      EXPECT_TRUE(TimeNs(e.t_ns) >= interval.t0 && TimeNs(e.t_ns) < interval.t1);
      last = e.t_ns;
    }
  }
  EXPECT_NEAR(static_cast<double>(out), kHz, 60);  // a second
  const std::uint64_t waiting = in - out - lost;
  EXPECT_LE(waiting, 51u);
}

// The mean wait of a queue of Poisson arrivals and a constant service 1 / mu: rho / (2 mu (1 - rho)).
TEST(Arbiter, WaitsAsAQueueDoes) {
  constexpr double kMu = 1000, kRho = 0.6;
  Arbiter arbiter(kMu, 60'000);
  std::mt19937_64 random(2);
  const Interval interval{TimeNs(0), TimeNs(300 * kSecond), 1};
  Events events = poisson(kRho * kMu, interval, random);
  const Events arrived = events;
  EXPECT_EQ(arbiter.pass(events, interval), 0u);
  double wait = 0;
  for (std::size_t i = 0; i < events.size(); ++i)
    wait += 1e-9 * static_cast<double>(events[i].t_ns - arrived[i].t_ns);
  EXPECT_NEAR(wait / static_cast<double>(events.size()) / (kRho / (2 * kMu * (1 - kRho))), 1, 0.03);
}

TEST(Arbiter, AnExtremeThroughputIsHarmless) {
  for (const double hz : {5e-324, 1e-9, 1e10}) {
    Arbiter arbiter(hz, 65536);
    for (FrameIndex i = 1; i <= 3; ++i) {
      const Interval interval{TimeNs((i - 1) * kSecond), TimeNs(i * kSecond), i};
      Events events(70'000, Event{interval.t0.count(), 0, 0, 1});
      arbiter.pass(events, interval);
      for (const Event& e : events) ASSERT_LT(TimeNs(e.t_ns), interval.t1);
    }
  }
}

}  // namespace
}  // namespace saccade
