// Noise that changes between two intervals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "events/noise/presets.h"
#include "noise_run.h"

namespace saccade {
namespace {

using test::SensorRun;
constexpr int kWidth = 61, kHeight = 29;
constexpr TimeNs kMs{1'000'000};

void fillRandom(IntensityChange& change, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-0.4f, 0.4f);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) change.dI.at(x, y) = uniform(random);
}

// The events of twenty intervals. The sensor has `first` until the tenth begins, and `then` from there on.
Events eventsOf(const NoiseConfig& first, const NoiseConfig& then) {
  SensorConfig config{.refractory = TimeNs(100'000), .seed = 9};
  config.noise = first;
  SensorRun run(config, kWidth, kHeight);
  for (unsigned i = 0; i < 20; ++i) {
    if (i == 10 && then != first) run.sensor.change({.noise = then});
    fillRandom(run.change, i);
    run.step();
  }
  return run.all;
}

Events ofSource(Events events, int source) {
  std::erase_if(events, [&](const Event& e) { return e.source != source; });
  return events;
}

Events during(Events events, TimeNs from, TimeNs until) {
  std::erase_if(events, [&](const Event& e) { return TimeNs(e.t_ns) < from || TimeNs(e.t_ns) >= until; });
  return events;
}

const NoiseConfig kLittle{.leak_hz = 100, .shot_hz = 50};
const NoiseConfig kMuch{.leak_hz = 30, .shot_hz = 400, .hot_fraction = 0.1, .hot_hz = 1000};

TEST(NoiseChange, KeepsTheEventsOfTheSignal) {
  const Events clean = eventsOf({}, {});
  EXPECT_EQ(ofSource(eventsOf(kLittle, kMuch), 0), clean);
  EXPECT_EQ(ofSource(eventsOf({}, kMuch), 0), clean);
  EXPECT_EQ(ofSource(eventsOf(kMuch, {}), 0), clean);
}

TEST(NoiseChange, NoiseIsAsIfItHadAlwaysBeenSo) {
  const Events changed = ofSource(eventsOf(kLittle, kMuch), 1);
  const Events before = ofSource(eventsOf(kLittle, kLittle), 1), after = ofSource(eventsOf(kMuch, kMuch), 1);
  EXPECT_EQ(during(changed, 0 * kMs, 10 * kMs), during(before, 0 * kMs, 10 * kMs));
  EXPECT_EQ(during(changed, 10 * kMs, 20 * kMs), during(after, 10 * kMs, 20 * kMs));
  EXPECT_GT(during(changed, 10 * kMs, 20 * kMs).size(), 2 * during(changed, 0 * kMs, 10 * kMs).size());
}

TEST(NoiseChange, TheReadoutMayComeAndGo) {
  const NoiseConfig slow{.dead_fraction = 0.2, .jitter_s = 1e-4, .readout_hz = 2e5};
  const Events clean = eventsOf({}, {}), on = eventsOf({}, slow), off = eventsOf(slow, {});
  EXPECT_EQ(during(on, 0 * kMs, 10 * kMs), during(clean, 0 * kMs, 10 * kMs));
  EXPECT_LE(during(on, 10 * kMs, 20 * kMs).size(), 2001u);
  EXPECT_EQ(during(off, 0 * kMs, 10 * kMs), during(eventsOf(slow, slow), 0 * kMs, 10 * kMs));
  EXPECT_EQ(during(off, 11 * kMs, 20 * kMs), during(clean, 11 * kMs, 20 * kMs));
}

TEST(NoiseChange, EventsStayInOrderAndInsideTheInterval) {
  SensorConfig config{.seed = 2};
  config.noise = {.mismatch = 0.15, .readout_hz = 1e5};
  SensorRun run(config, kWidth, kHeight);
  for (unsigned i = 0; i < 60; ++i) {
    NoiseConfig noise = sensorPresets()[i % 3].noise;
    noise.mismatch = 0.15;
    noise.readout_hz = i % 2 ? 0 : 1e5 * (1 + i % 7);
    run.sensor.change({.noise = noise});
    fillRandom(run.change, i);
    const SensorOutput& out = run.step();
    EXPECT_TRUE(std::ranges::is_sorted(out.events, {}, &Event::t_ns));
    for (const Event& e : out.events)
      ASSERT_TRUE(TimeNs(e.t_ns) >= run.change.t0 && TimeNs(e.t_ns) < run.change.t1);
  }
}

// The lag of a photoreceptor after a step of 1 in the first millisecond, by how many Hz it has.
class PhotoreceptorChange : public testing::Test {
 protected:
  float step(float dL) {
    change_.t0 = change_.t1, change_.t1 += kMs;
    dL_.at(0, 0) = dL;
    filter_.filter(change_, dL_);
    return dL_.at(0, 0);
  }
  static double shareOf(double hz) { return 1 - std::exp(-2 * std::numbers::pi * hz * 1e-3); }

  static constexpr NoiseConfig kOnePole{.photoreceptor_hz = 20},
      kTwoPoles{.photoreceptor_hz = 20, .follower_hz = 30};
  Photoreceptor filter_{kOnePole, 1, 1};
  IntensityChange change_ = [] {
    IntensityChange change(1, 1);
    change.I_now.fill(1);
    return change;
  }();
  ImageF dL_{1, 1};
};

TEST_F(PhotoreceptorChange, TheLagGoesOnWithTheNewBandwidth) {
  const float lag = 1 - step(1);
  filter_.change({.photoreceptor_hz = 200});
  EXPECT_NEAR(step(0), lag * shareOf(200), 1e-5);
}

TEST_F(PhotoreceptorChange, WithoutABandwidthTheLagComesOutAtOnce) {
  const float lag = 1 - step(1);
  filter_.change({});
  EXPECT_NEAR(step(0), lag, 1e-5);
  EXPECT_NEAR(step(0.5f), 0.5, 1e-5);
}

TEST_F(PhotoreceptorChange, AFollowerBeginsWithoutALagAndLosesNone) {
  float seen = step(1);
  filter_.change(kTwoPoles);
  EXPECT_LT(step(0), (1 - seen) * shareOf(20) * shareOf(30));  // it follows both, one behind the other
  seen = 0;
  filter_ = Photoreceptor(kTwoPoles, 1, 1);
  seen += step(1);
  seen += step(0);
  filter_.change({});
  EXPECT_NEAR(seen + step(0), 1, 1e-4);
}

TEST(ArbiterChange, WhoWaitsIsTakenAtTheNewRate) {
  const auto timesAfter = [](double hz) {
    Arbiter arbiter(1000, 100);
    Events events(5, Event{0, 0, 0, 1});
    arbiter.pass(events, {0 * kMs, 1 * kMs, 1});
    EXPECT_EQ(events.size(), 1u);
    EXPECT_TRUE(arbiter.waits());
    arbiter.change(hz, 100);
    events.assign(1, Event{1'200'000, 0, 0, 1});
    EXPECT_EQ(arbiter.pass(events, {1 * kMs, 9 * kMs, 2}), 0u);
    EXPECT_FALSE(arbiter.waits());
    std::vector<std::int64_t> us;
    for (const Event& e : events) us.push_back(e.t_ns / 1000);
    return us;
  };
  EXPECT_EQ(timesAfter(1000), (std::vector<std::int64_t>{1000, 2000, 3000, 4000, 5000}));
  EXPECT_EQ(timesAfter(2000), (std::vector<std::int64_t>{1000, 1500, 2000, 2500, 3000}));
  EXPECT_EQ(timesAfter(0), (std::vector<std::int64_t>{1000, 1000, 1000, 1000, 1200}));
}

}  // namespace
}  // namespace saccade
