// Pixels whose thresholds change between two intervals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "events/model_run.h"
#include "events/sensor.h"

namespace saccade::test {
namespace {

constexpr int kWidth = 64, kHeight = 16, kPixels = kWidth * kHeight;
const SensorConfig kConfig{.threshold = 0.4, .threshold_off = 0.4, .seed = 3};

SensorConfig withThresholds(double on, double off) {
  SensorConfig config = kConfig;
  config.threshold = on, config.threshold_off = off;
  return config;
}

// Levels are uniform in (-0.4, 0.4) at the start: a half of them lies outside of 0.2.
TEST(ThresholdChange, PixelsBeyondFireOnceAtTheBeginning) {
  ModelRun run(kConfig, kWidth, kHeight);
  std::vector<bool> beyond, on;
  for (int i = 0; i < kPixels; ++i) {
    const float v = run.model->level(i % kWidth, i / kWidth);
    beyond.push_back(std::abs(v) >= 0.2f);
    on.push_back(v > 0);
  }
  run.step(0.f);
  run.model->setThresholds(withThresholds(0.2, 0.2));
  const Events& events = run.step(0.f);
  EXPECT_NEAR(static_cast<double>(events.size()), kPixels / 2.0, 4 * std::sqrt(kPixels) / 2);
  EXPECT_EQ(static_cast<std::ptrdiff_t>(events.size()), std::count(beyond.begin(), beyond.end(), true));
  for (const Event& e : events) {
    const auto i = static_cast<std::size_t>(e.y * kWidth + e.x);
    EXPECT_TRUE(beyond[i]);
    EXPECT_EQ(e.p == 1, on[i]);
    EXPECT_EQ(e.t_ns, kMs.count());
    EXPECT_EQ(run.model->level(e.x, e.y), 0);
  }
  EXPECT_TRUE(run.step(0.f).empty());
}

TEST(ThresholdChange, PixelsWithinKeepTheirReference) {
  ModelRun run(kConfig, kWidth, kHeight);
  int x = 0;
  while (std::abs(run.model->level(x, 0)) > 0.1f) ++x;
  const float level = run.model->level(x, 0);
  run.model->setThresholds(withThresholds(0.2, 0.3));
  run.step([&](int px, int py) { return px == x && py == 0 ? 0.05f : 0.f; });
  EXPECT_NEAR(run.model->level(x, 0), level + 0.05f, 1e-6);
}

TEST(ThresholdChange, KeepsTheBoundsOfEvents) {
  SensorConfig config = kConfig;
  config.max_events_per_pixel_frame = 2;
  ModelRun run(config, kWidth, kHeight);
  run.model->setThresholds(withThresholds(0.01, 0.01));
  std::vector<int> counts(kPixels);
  for (const Event& e : run.step(1.f)) ++counts[static_cast<std::size_t>(e.y * kWidth + e.x)];
  EXPECT_EQ(*std::max_element(counts.begin(), counts.end()), 2);
  EXPECT_EQ(*std::min_element(counts.begin(), counts.end()), 2);

  config.max_events_per_frame = 10;
  ModelRun few(config, kWidth, kHeight);
  few.model->setThresholds(withThresholds(0.2, 0.2));
  EXPECT_EQ(few.step(0.f).size(), 10u);
  EXPECT_GT(few.suppressed, 100u);
}

TEST(ThresholdChange, APixelThatFiresIsBlindAfterwards) {
  SensorConfig config = kConfig;
  config.refractory = 2 * kMs;
  ModelRun run(config, kWidth, kHeight);
  run.model->setThresholds(withThresholds(0.1, 0.1));
  const Events first = run.step(0.f);
  ASSERT_FALSE(first.empty());
  std::vector<bool> blind(kPixels);
  for (const Event& e : first) blind[static_cast<std::size_t>(e.y * kWidth + e.x)] = true;
  for (const Event& e : run.step(0.5f)) EXPECT_FALSE(blind[static_cast<std::size_t>(e.y * kWidth + e.x)]);
}

// Equal intensities before and after: a change of the bias alone is no change of brightness.
TEST(ThresholdChange, AnotherBiasMakesNoEvent) {
  for (const ReconstructionInfo& info : reconstructionTable()) {
    SCOPED_TRACE(info.name);
    SensorConfig config = kConfig;
    config.reconstruction = info.name;
    Sensor sensor(config, kWidth, kHeight);
    IntensityChange change(kWidth, kHeight);
    SensorOutput out;
    for (FrameIndex frame = 1; frame <= 4; ++frame) {
      if (frame == 3) sensor.change({.bias = 0.5});
      change.frame = frame;
      change.t0 = frameTime(frame - 1, 500), change.t1 = frameTime(frame, 500);
      change.I_prev.fill(0.7f);
      change.I_now.fill(0.7f);
      change.var_I_prev.fill(0.01f);
      change.var_dI.fill(0.01f);
      sensor.generate(change, out);
      EXPECT_TRUE(out.events.empty()) << frame;
    }
  }
}

}  // namespace
}  // namespace saccade::test
