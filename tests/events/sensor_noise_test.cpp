// The layer of noise as a whole: it never changes the events of the signal.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base/counting_new.h"
#include "events/noise/presets.h"
#include "noise_run.h"

namespace saccade {
namespace {

using test::SensorRun;
constexpr int kWidth = 61, kHeight = 29;

void fillRandom(IntensityChange& change, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-0.4f, 0.4f);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) change.dI.at(x, y) = uniform(random);
}

Events eventsOf(const SensorConfig& config) {
  SensorRun run(config, kWidth, kHeight);
  for (unsigned i = 0; i < 20; ++i) {
    fillRandom(run.change, i);
    run.step();
  }
  return run.all;
}

TEST(SensorNoise, EventsOfTheSignalAreThoseWithoutNoise) {
  for (const char* model : {"accumulating", "probabilistic"}) {
    SensorConfig plain{.model = model, .refractory = TimeNs(100'000), .seed = 9}, noisy = plain;
    noisy.noise = {.leak_hz = 200, .shot_hz = 400, .hot_fraction = 0.1, .hot_hz = 1000};
    const Events clean = eventsOf(plain);
    Events signal = eventsOf(noisy);
    const auto noise = std::erase_if(signal, [](const Event& e) { return e.source == 1; });
    EXPECT_GT(noise, 1000u);
    EXPECT_EQ(signal, clean);
    for (const Event& e : clean) ASSERT_EQ(e.source, 0);
  }
}

TEST(SensorNoise, EachPartChangesTheEvents) {
  const Events clean = eventsOf({.seed = 9});
  const NoiseConfig parts[] = {{.mismatch = 0.1},  {.photoreceptor_hz = 100}, {.leak_hz = 100},
                               {.shot_hz = 100},   {.hot_fraction = 0.1},     {.dead_fraction = 0.1},
                               {.jitter_s = 1e-4}, {.readout_hz = 1e5}};
  for (const NoiseConfig& part : parts) {
    SensorConfig config{.seed = 9};
    config.noise = part;
    EXPECT_NE(eventsOf(config), clean);
    EXPECT_EQ(eventsOf(config), eventsOf(config));
  }
}

TEST(SensorNoise, EventsStayInOrderAndInsideTheInterval) {
  for (const SensorPreset& preset : sensorPresets()) {
    SensorConfig config{.seed = 2};
    config.noise = preset.noise;
    config.noise.shot_hz = 300;
    config.noise.readout_hz = 1e6;
    SensorRun run(config, kWidth, kHeight);
    for (unsigned i = 0; i < 20; ++i) {
      fillRandom(run.change, i);
      const SensorOutput& out = run.step();
      EXPECT_TRUE(std::ranges::is_sorted(out.events, {}, &Event::t_ns));
      for (const Event& e : out.events) {
        ASSERT_TRUE(TimeNs(e.t_ns) >= run.change.t0 && TimeNs(e.t_ns) < run.change.t1);
        ASSERT_TRUE(e.x < kWidth && e.y < kHeight);
      }
      EXPECT_GE(out.suppressed, out.lost_in_readout);
    }
  }
}

TEST(SensorNoise, ALossInTheReadoutIsCounted) {
  SensorConfig config{.seed = 1};
  config.noise.readout_hz = 1e5;
  config.noise.readout_buffer = 10;
  SensorRun run(config, kWidth, kHeight);
  fillRandom(run.change, 1);
  const SensorOutput& out = run.step();
  EXPECT_EQ(out.lost_in_readout, out.suppressed);
  EXPECT_LE(out.events.size(), 101u);
  EXPECT_GT(out.lost_in_readout, 500u);
}

TEST(SensorNoise, APresetIsWithinTheRangesAndAllocatesNothingAfterwards) {
  for (const SensorPreset& preset : sensorPresets()) {
    SensorConfig config{.threshold = preset.threshold, .threshold_off = preset.threshold_off};
    config.noise = preset.noise;
    ASSERT_FALSE(findFault(config)) << preset.name;
    Sensor sensor(config, kWidth, kHeight);
    IntensityChange change(kWidth, kHeight);
    SensorOutput out;
    int before = 0;
    for (unsigned i = 1; i <= 120; ++i) {
      if (i == 100) before = test::allocations();
      fillRandom(change, i % 2);
      change.frame = i, change.t0 = frameTime(i - 1, 500), change.t1 = frameTime(i, 500);
      sensor.generate(change, out);
    }
    EXPECT_EQ(test::allocations(), before) << preset.name;
  }
}

TEST(SensorNoise, AFollowerNeedsAPhotoreceptor) {
  SensorConfig config;
  config.noise.follower_hz = 10;
  EXPECT_EQ(findFault(config)->field, "noise.follower_hz");
}

}  // namespace
}  // namespace saccade
