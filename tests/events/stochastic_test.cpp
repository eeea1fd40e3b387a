// The stochastic model against the first passage of a Brownian motion with drift. The bounds are five
// standard deviations, at a fixed seed.
#include <gtest/gtest.h>

#include <cmath>

#include "base/counting_new.h"
#include "events/models/first_passage.h"
#include "noise_run.h"
#include "update_run.h"

namespace saccade {
namespace {

using test::SensorRun;
using test::UpdateRun;
constexpr double kOn = 0.2, kOff = 0.3;

// From 0, of a motion with drift m and variance s2 per second [optional stopping]:
//   P(ON) = (1 - exp(2 m b / s2)) / (exp(-2 m a / s2) - exp(2 m b / s2)),  E[t] = (a P(ON) - b P(OFF)) / m.
struct Expected {
  double on, time;
};
Expected expectedPassage(double m, double s2) {
  if (m == 0) return {kOff / (kOn + kOff), kOn * kOff / s2};
  const double up = std::exp(-2 * m * kOn / s2), down = std::exp(2 * m * kOff / s2);
  const double on = (1 - down) / (up - down);
  return {on, (kOn * on - kOff * (1 - on)) / m};
}

TEST(FirstPassage, HasItsMeanTimeAndShareOfBarriers) {
  constexpr int kCount = 3000;
  for (const double m : {0.0, 0.4, -1.5})
    for (const double step : {0.03, 5.0}) {  // paths of this time, one after the other
      const double s2 = 0.1;
      double on = 0, time = 0, squares = 0;
      for (int i = 0; i < kCount; ++i) {
        NumberRow numbers(hashKey(7, static_cast<std::uint64_t>(i)));
        double t = 0, v = 0;
        Passage passage{};
        do {
          passage = firstPassage({v, m * step, s2 * step}, kOn, kOff, 1e-5, numbers);
          t += passage.at * step, v = passage.level;
        } while (!passage.crosses);
        on += passage.level > 0, time += t, squares += t * t;
      }
      const Expected expected = expectedPassage(m, s2);
      const double variance = squares / kCount - std::pow(time / kCount, 2);
      EXPECT_NEAR(on / kCount, expected.on, 5 * std::sqrt(0.25 / kCount)) << m << ' ' << step;
      EXPECT_NEAR(time / kCount, expected.time, 5 * std::sqrt(variance / kCount)) << m << ' ' << step;
    }
}

// Without noise it is where the line meets the barrier.
TEST(FirstPassage, OfALineIsExact) {
  NumberRow numbers(1);
  const Passage passage = firstPassage({0.1, 0.4, 1e-18}, kOn, kOff, 1e-4, numbers);
  EXPECT_TRUE(passage.crosses);
  EXPECT_NEAR(passage.at, 0.25, 2e-4);
  EXPECT_EQ(passage.level, kOn);
  EXPECT_FALSE(firstPassage({0.1, 0.05, 1e-18}, kOn, kOff, 1e-4, numbers).crosses);
}

SensorConfig stochastic(double hz) {
  SensorConfig config{.threshold = kOn,
                      .threshold_off = kOff,
                      .model = "stochastic",
                      .random_start = false,
                      .reconstruction = "direct",
                      .seed = 3};
  config.noise.brownian_hz = hz;
  return config;
}

// A renewal process of mean gap T and variation c has t / T + (c^2 - 1) / 2 events by t; here c is at most 1.
TEST(Stochastic, AStillPixelHasItsRateAtEachIntensity) {
  constexpr int kSide = 20;
  constexpr double kHz = 3, kSeconds = 4;
  for (const auto& [I, factor] : {std::pair(1.f, 1.0), {4.f, 0.25}, {0.25f, 4.0}, {0.f, 10.0}, {NAN, 10.0}}) {
    SensorRun run(stochastic(kHz), kSide, kSide);
    run.setIntensity(I);
    for (int i = 0; i < kSeconds * 50; ++i) run.step(TimeNs(20'000'000));
    double on = 0;
    for (const Event& e : run.all) on += e.p;
    const double count = static_cast<double>(run.all.size()), pixels = kSide * kSide;
    const double expected = kHz * factor * kSeconds;
    EXPECT_NEAR(count / pixels, expected, 0.3 + 5 * std::sqrt(expected / pixels)) << I;
    EXPECT_NEAR(on / count, kOff / (kOn + kOff), 5 * std::sqrt(0.25 / count)) << I;
  }
}

// The share of OFF events on a rising edge falls with its slope, as exp(-2 m C- / s^2).
TEST(Stochastic, NoiseDependsOnTheSlope) {
  constexpr double kHz = 10, kSlope = 0.5, s2 = kHz * kOn * kOff;
  UpdateRun run(stochastic(kHz), 24, 24, [](int, int, double t) { return kSlope * 0.016 * t; });
  for (int i = 0; i < 250; ++i) run.whole();
  const auto noiseAt = [&](double L) { return s2 / std::max(0.1, std::exp(L)); };
  double on = 0, count = 0, expected = 0, rate = 0;
  for (const Event& e : run.all) on += e.p, ++count;
  for (int i = 0; i < 250; ++i) {
    const Expected at = expectedPassage(kSlope, noiseAt(kSlope * 0.016 * (i + 1)));
    expected += 0.016 / at.time * at.on, rate += 0.016 / at.time;
  }
  const double pixels = 24 * 24;
  EXPECT_NEAR(count / pixels, rate, 0.5 + 5 * std::sqrt(rate / pixels));
  EXPECT_NEAR(on / count, expected / rate, 5 * std::sqrt(0.25 / count));
}

TEST(Stochastic, UpdatesChangeNothingOnAverage) {
  const auto L = [](int, int, double t) { return 0.4 * std::sin(0.2 * t); };
  UpdateRun whole(stochastic(3), 20, 20, L), updated(stochastic(3), 20, 20, L);
  for (int i = 0; i < 100; ++i) updated.updated(4);
  for (int i = 0; i < 400; ++i) whole.whole(4);
  const double n = static_cast<double>(whole.all.size());
  EXPECT_GT(n, 4000);
  EXPECT_NEAR(static_cast<double>(updated.all.size()), n, 5 * std::sqrt(2 * n));
}

TEST(Stochastic, ABlindPixelWaits) {
  SensorConfig config = stochastic(100);
  config.refractory = TimeNs(7'000'000);
  SensorRun run(config, 16, 16);
  run.setIntensity(0);
  for (int i = 0; i < 500; ++i) run.step(TimeNs(1'000'000));
  std::vector<std::int64_t> last(256, INT64_MIN / 2);
  for (const Event& e : run.all) {
    EXPECT_GE(e.t_ns - last[e.y * 16 + e.x], 7'000'000 - 1000);
    last[e.y * 16 + e.x] = e.t_ns;
  }
  EXPECT_NEAR(static_cast<double>(run.all.size()) / 256, 0.5 / (0.007 + 1e-3), 3);
}

// Within its bounds a huge change takes no longer than a small one, and all that is withheld counts.
TEST(Stochastic, BoundsHold) {
  SensorConfig config = stochastic(1);
  config.max_events_per_frame = 100;
  SensorRun run(config, 16, 16);
  run.change.dI.fill(1e18f);
  const SensorOutput& out = run.step();
  EXPECT_EQ(out.events.size(), 100u);
  const double thresholds = std::log(1e18) / kOn * 256;
  EXPECT_NEAR(static_cast<double>(out.events.size() + out.suppressed), thresholds, 0.02 * thresholds);
}

TEST(Stochastic, NothingAllocatesAfterTwoFrames) {
  SensorRun run(stochastic(50), 16, 16);
  for (int i = 0; i < 20; ++i) run.step(TimeNs(20'000'000));
  const int before = test::allocations();
  run.sensor.generate(run.change, run.out);
  EXPECT_EQ(test::allocations() - before, 0);
}

TEST(Stochastic, WithoutBrownianMotionItIsAccumulating) {
  SensorConfig plain = stochastic(0);
  plain.model = "accumulating";
  const auto L = [](int x, int y, double t) { return std::sin(t + x + y); };
  UpdateRun a(stochastic(0), 8, 8, L), b(plain, 8, 8, L);
  for (int i = 0; i < 20; ++i) a.whole(), b.whole();
  EXPECT_EQ(a.all, b.all);
  EXPECT_EQ(findFault([] {
              SensorConfig config;
              config.noise.brownian_hz = 1;
              return config;
            }())
                ->field,
            "noise.brownian_hz");
}

}  // namespace
}  // namespace saccade
