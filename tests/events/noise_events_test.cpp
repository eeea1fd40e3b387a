// Leak, shot noise and hot pixels against their formulas. The bounds are five standard deviations, at a fixed
// seed.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "noise_run.h"

namespace saccade {
namespace {

using test::SensorRun;
constexpr int kSide = 64, kPixels = kSide * kSide;

SensorConfig with(const NoiseConfig& noise) {
  SensorConfig config;
  config.seed = 3;
  config.noise = noise;
  return config;
}

Events eventsOf(const NoiseConfig& noise, float I, int steps, TimeNs length) {
  SensorRun run(with(noise), kSide, kSide);
  run.setIntensity(I);
  for (int i = 0; i < steps; ++i) run.step(length);
  return run.all;
}

TEST(Leak, EveryPixelHasOneEventInEachPeriodAtItsOwnPhase) {
  const Events events = eventsOf({.leak_hz = 4}, 1, 1000, TimeNs(1'000'000));  // a second
  ASSERT_EQ(events.size(), 4u * kPixels);
  std::map<int, std::vector<std::int64_t>> times;
  for (const Event& e : events) {
    EXPECT_EQ(e.p, 1);
    EXPECT_EQ(e.source, 1);
    times[e.y * kSide + e.x].push_back(e.t_ns);
  }
  ASSERT_EQ(times.size(), std::size_t(kPixels));
  std::vector<int> phases(16);  // of the period
  for (const auto& [pixel, t] : times) {
    ASSERT_EQ(t.size(), 4u);
    for (int k = 1; k < 4; ++k) EXPECT_NEAR(static_cast<double>(t[k] - t[k - 1]), 250e6, 1000);
    ++phases[t[0] / (250'000'000 / 16)];
  }
  // Chi-square of 15 degrees of freedom: 44.3 is passed once in 10,000.
  double chi2 = 0;
  for (const int count : phases) chi2 += std::pow(count - kPixels / 16.0, 2) / (kPixels / 16.0);
  EXPECT_LT(chi2, 44.3);
}

TEST(Leak, FramesOfAnyLengthGiveTheSameEvents) {
  const Events coarse = eventsOf({.leak_hz = 30}, 1, 3, TimeNs(99'000'000));
  EXPECT_EQ(coarse, eventsOf({.leak_hz = 30}, 1, 297, TimeNs(1'000'000)));
}

// r(I) = shot_hz (1 - 3/4 I / R)
TEST(ShotNoise, ItsRateFallsWithIntensity) {
  constexpr double kSeconds = 4, kHz = 5;
  for (const auto& [I, share] : {std::pair(0.f, 1.0), {1.f, 0.625}, {2.f, 0.25}, {50.f, 0.25}, {NAN, 1.0}}) {
    const Events events = eventsOf({.reference_luminance = 2, .shot_hz = kHz}, I, 400, TimeNs(10'000'000));
    const double mean = kHz * share * kSeconds * kPixels;
    EXPECT_NEAR(static_cast<double>(events.size()), mean, 5 * std::sqrt(mean)) << I;
    double on = 0;
    for (const Event& e : events) on += e.p;
    EXPECT_NEAR(on, mean / 2, 5 * std::sqrt(mean) / 2 + 5 * std::sqrt(mean) / 2) << I;
  }
}

// The counts of a Poisson process have a variance equal to their mean, over pixels and over times.
TEST(ShotNoise, IsPoisson) {
  const Events events = eventsOf({.shot_hz = 20}, 0, 1000, TimeNs(1'000'000));
  std::vector<double> pixels(kPixels), times(1000);
  for (const Event& e : events) ++pixels[e.y * kSide + e.x], ++times[e.t_ns / 1'000'000];
  for (const auto& counts : {pixels, times}) {
    const double n = static_cast<double>(counts.size()), mean = static_cast<double>(events.size()) / n;
    double variance = 0;
    for (const double count : counts) variance += (count - mean) * (count - mean) / (n - 1);
    EXPECT_NEAR(variance / mean, 1, 5 * std::sqrt(2 / n + 1 / (mean * n)));
  }
}

TEST(HotPixels, AShareOfThePixelsFiresAtItsRate) {
  const Events events = eventsOf({.hot_fraction = 0.05, .hot_hz = 200}, 1, 10, TimeNs(100'000'000));
  std::map<int, int> counts;
  for (const Event& e : events) ++counts[e.y * kSide + e.x];
  EXPECT_NEAR(static_cast<double>(counts.size()), 0.05 * kPixels, 5 * std::sqrt(0.05 * 0.95 * kPixels));
  for (const auto& [pixel, count] : counts) EXPECT_EQ(count, 200);
}

TEST(NoiseEvents, LeaveTheBoundOfEventsToTheSignalAndCountTheRest) {
  SensorConfig config = with({.leak_hz = 1000});
  config.max_events_per_frame = 100;
  SensorRun run(config, kSide, kSide);
  const SensorOutput& out = run.step();
  EXPECT_EQ(out.events.size(), 100u);
  EXPECT_EQ(out.suppressed, kPixels - 100u);
}

// The rates of the pixels have the mean r, and the variance r^2 (exp(s^2) - 1). Shot noise is a Poisson
// process in each of them, whose counts have the mean more variance.
TEST(RateSpread, IsLogNormalOverThePixels) {
  constexpr double kSpread = 0.6, kHz = 20, kSeconds = 10, kMean = kHz * kSeconds;
  for (const NoiseConfig& noise : {NoiseConfig{.leak_hz = kHz, .rate_spread = kSpread},
                                   NoiseConfig{.shot_hz = kHz, .rate_spread = kSpread}}) {
    std::vector<double> counts(kPixels);
    for (const Event& e : eventsOf(noise, 0, 100, TimeNs(100'000'000))) ++counts[e.y * kSide + e.x];
    double sum = 0, squares = 0;
    for (const double n : counts) sum += n, squares += n * n;
    const double mean = sum / kPixels, share = std::expm1(kSpread * kSpread);
    const double variance = kMean * kMean * share + (noise.shot_hz > 0 ? kMean : 0);
    EXPECT_NEAR(mean / kMean, 1, 5 * std::sqrt(share / kPixels));
    EXPECT_NEAR((squares / kPixels - mean * mean) / variance, 1, 0.25) << "its tail is heavy";
  }
}

TEST(RateSpread, FramesOfAnyLengthGiveTheSameLeak) {
  const NoiseConfig noise{.leak_hz = 30, .rate_spread = 0.5};
  const Events fine = eventsOf(noise, 1, 297, TimeNs(1'000'000));
  EXPECT_EQ(eventsOf(noise, 1, 3, TimeNs(99'000'000)), fine);
  EXPECT_NEAR(static_cast<double>(fine.size()), 0.297 * 30 * kPixels, 0.05 * 0.297 * 30 * kPixels);
}

// Dark current adds to I: the response, and the light of shot noise, are those of a brighter scene.
TEST(DarkCurrent, FlattensTheResponseBelowIt) {
  SensorConfig dark = with({.dark_luminance = 0.5}), bright = with({});
  dark.bias = 0.001, bright.bias = 0.501;
  SensorRun a(dark, kSide, kSide), b(bright, kSide, kSide);
  for (SensorRun* run : {&a, &b}) {
    run->setIntensity(0);
    for (int i = 0; i < 20; ++i) run->change.dI.fill(0.01f * static_cast<float>(i)), run->step();
  }
  EXPECT_EQ(a.all, b.all);
  EXPECT_FALSE(a.all.empty());
  EXPECT_EQ(eventsOf({.dark_luminance = 0.75, .shot_hz = 5}, 0.25f, 10, TimeNs(100'000'000)),
            eventsOf({.shot_hz = 5}, 1, 10, TimeNs(100'000'000)));
}

}  // namespace
}  // namespace saccade
