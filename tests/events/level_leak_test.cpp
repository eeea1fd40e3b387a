// Leak that moves the level, against the events of a ramp.
#include <gtest/gtest.h>

#include <cmath>

#include "noise_run.h"
#include "update_run.h"

namespace saccade {
namespace {

using test::SensorRun;
using test::UpdateRun;
constexpr int kSide = 48, kPixels = kSide * kSide;
constexpr double kOn = 0.2, kOff = 0.3;

SensorConfig leaking(double hz, double spread = 0) {
  SensorConfig config{
      .threshold = kOn, .threshold_off = kOff, .random_start = false, .reconstruction = "direct", .seed = 3};
  config.noise.level_leak_hz = hz;
  config.noise.rate_spread = spread;
  return config;
}

TEST(LevelLeak, AStillPixelSendsOnEventsAtItsRate) {
  SensorRun run(leaking(10), kSide, kSide);
  for (int i = 0; i < 1050; ++i) run.step(TimeNs(1'000'000));
  EXPECT_EQ(run.all.size(), 10u * kPixels);
  for (const Event& e : run.all) {
    EXPECT_EQ(e.p, 1);
    EXPECT_NEAR(std::remainder(static_cast<double>(e.t_ns), 1e8), 0, 1e4)
        << "each 0.1 s, from the first reference on";
  }
}

// On a ramp of slope m, ON events come at the rate (m + r C+) / C+, and OFF events at -(m + r C+) / C-. Of 2
// seconds.
TEST(LevelLeak, ARampHasMoreOnAndFewerOffEvents) {
  constexpr double kHz = 4, kLeak = kHz * kOn;
  for (const double slope : {1.1, -1.9, -0.3}) {
    UpdateRun run(leaking(kHz), 2, 2, [&](int, int, double t) { return slope * 0.016 * t; });
    for (int i = 0; i < 125; ++i) run.whole();
    const double rise = 2 * (slope + kLeak);
    EXPECT_NEAR(static_cast<double>(run.all.size()) / 4, std::floor(std::abs(rise) / (rise > 0 ? kOn : kOff)),
                1e-9)
        << slope;
    for (const Event& e : run.all) EXPECT_EQ(e.p == 1, rise > 0);
  }
}

TEST(LevelLeak, UpdatesGiveTheEventsOfWholePictures) {
  const auto L = [](int x, int, double t) { return 0.3 * std::sin(0.5 * t + x); };
  UpdateRun whole(leaking(20), 4, 1, L), updated(leaking(20), 4, 1, L);
  for (int i = 0; i < 100; ++i) updated.updated(4);
  for (int i = 0; i < 400; ++i) whole.whole(4);
  ASSERT_EQ(updated.all.size(), whole.all.size());
  EXPECT_GT(whole.all.size(), 80u);
  for (std::size_t i = 0; i < whole.all.size(); ++i)
    EXPECT_NEAR(static_cast<double>(updated.all[i].t_ns), static_cast<double>(whole.all[i].t_ns), 20e3);
}

// ln(rate) is normal, with the deviation s, and the mean rate is r.
TEST(LevelLeak, ItsSpreadOfRatesIsLogNormal) {
  constexpr double kSpread = 0.5, kHz = 50, kSeconds = 4;
  SensorRun run(leaking(kHz, kSpread), kSide, kSide);
  for (int i = 0; i < kSeconds * 100; ++i) run.step(TimeNs(10'000'000));
  std::vector<double> counts(kPixels);
  for (const Event& e : run.all) ++counts[e.y * kSide + e.x];
  double sum = 0, logs = 0, squares = 0;
  for (const double n : counts) {
    const double log = std::log((n + 0.5) / (kHz * kSeconds));
    sum += n, logs += log, squares += log * log;
  }
  const double mean = logs / kPixels, deviation = std::sqrt(squares / kPixels - mean * mean);
  EXPECT_NEAR(sum / kPixels / (kHz * kSeconds), 1, 5 * std::sqrt(std::expm1(kSpread * kSpread) / kPixels));
  EXPECT_NEAR(mean, -kSpread * kSpread / 2, 5 * kSpread / std::sqrt(kPixels));
  EXPECT_NEAR(deviation, kSpread, 5 * kSpread / std::sqrt(2 * kPixels));
}

}  // namespace
}  // namespace saccade
