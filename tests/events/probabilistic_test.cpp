#include <gtest/gtest.h>

#include <cmath>

#include "model_run.h"

namespace saccade {
namespace {

using test::kMs;
using test::ModelRun;

constexpr int kEdge = 100;
constexpr double kPixels = kEdge * kEdge;

SensorConfig sensor(double on, double off) {
  return {.threshold = on, .threshold_off = off, .model = "probabilistic", .seed = 9};
}

// E[K] = |dL| / C [E (31)]. K takes two neighbouring values, so that its variance is r (1 - r), r the
// fractional part. Bound: 5 standard deviations, one false alarm in 1.7 million.
TEST(Probabilistic, ExpectedCountIsChangeOverThreshold) {
  const int frames = 20;
  for (const double change : {0.001, 0.03, 0.1, 0.25, 1.73, -0.001, -0.05, -0.4, -2.2}) {
    const SensorConfig config = sensor(0.2, 0.3);
    ModelRun run(config, kEdge, kEdge);
    double count = 0;
    for (int i = 0; i < frames; ++i) {
      for (const Event& e : run.step(static_cast<float>(change))) {
        ASSERT_EQ(e.p, change > 0);
        ++count;
      }
    }
    const double expected = std::abs(change) / (change > 0 ? config.threshold : config.threshold_off);
    const double r = expected - std::floor(expected), n = kPixels * frames;
    EXPECT_NEAR(count / n, expected, 5 * std::sqrt(r * (1 - r) / n) + 1e-6) << change;
  }
}

// Given one event, its time is uniform. Bound: 5 standard deviations of the mean.
TEST(Probabilistic, TimesAreSpreadOverTheInterval) {
  ModelRun run(sensor(0.2, 0.2), kEdge, kEdge);
  double sum = 0;
  const Events& events = run.step(0.1f);
  for (const Event& e : events) {
    ASSERT_GE(e.t_ns, 0);
    ASSERT_LT(e.t_ns, kMs.count());
    sum += static_cast<double>(e.t_ns + 500) / static_cast<double>(kMs.count());
  }
  const double n = static_cast<double>(events.size());
  EXPECT_NEAR(sum / n, 0.5, 5 * std::sqrt(1.0 / 12 / n));
}

TEST(Probabilistic, FramesAreIndependent) {
  ModelRun run(sensor(0.2, 0.2), kEdge, kEdge);
  const auto fired = [&] {
    std::vector<bool> pixels(kEdge * kEdge);
    for (const Event& e : run.step(0.1f)) pixels[e.y * kEdge + e.x] = true;
    return pixels;
  };
  const auto first = fired(), second = fired();
  int both = 0;
  for (int i = 0; i < kEdge * kEdge; ++i) both += first[i] && second[i];
  EXPECT_NEAR(both / kPixels, 0.25, 5 * std::sqrt(0.25 * 0.75 / kPixels));
}

TEST(Probabilistic, NoChangeGivesNoEvent) {
  ModelRun run(sensor(1e-3, 1e-3), kEdge, kEdge);
  EXPECT_TRUE(run.step(0.f).empty());
}

TEST(Probabilistic, TheBoundCountsWhatItWithholds) {
  SensorConfig config = sensor(0.1, 0.1);
  config.max_events_per_pixel_frame = 4;
  ModelRun run(config, kEdge, kEdge);
  EXPECT_EQ(run.step(1.f).size(), 4u * kEdge * kEdge);
  EXPECT_EQ(run.suppressed, 6u * kEdge * kEdge);
}

// Every pixel fires in the first frame and is blind for the second; what it misses is told once it has woken.
TEST(Probabilistic, RefractoryPeriodCrossesFrames) {
  SensorConfig config = sensor(0.1, 0.1);
  config.refractory = 2 * kMs;
  ModelRun run(config, kEdge, kEdge);
  EXPECT_EQ(run.step(0.1f).size(), kPixels);
  EXPECT_TRUE(run.step(0.55f).empty());
  EXPECT_EQ(run.suppressed, 0u);
  EXPECT_TRUE(run.step(0.f, 2 * kMs).empty());
  run.step(1e-6f);
  EXPECT_GE(run.suppressed, 5u * kEdge * kEdge);
  EXPECT_LE(run.suppressed, 6u * kEdge * kEdge);
}

}  // namespace
}  // namespace saccade
