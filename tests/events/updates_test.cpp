// Sensors whose intervals have updates.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/counting_new.h"
#include "events/update_run.h"

namespace saccade::test {
namespace {

constexpr int kWidth = 37, kHeight = 11, kParts = 16, kIntervals = 6;

SensorConfig plain() {
  return {.threshold = 0.15,
          .threshold_off = 0.2,
          .reconstruction = "direct",
          .max_events_per_pixel_frame = 1000,
          .seed = 4};
}

// Waves of other length and phase in each pixel, around -1.
double waves(int x, int y, double t) {
  return std::sin(t * (0.7 + 0.11 * x) + y) + 0.4 * std::sin(9.1 * t + x * y) - 1;
}

// Straight in each interval.
double ramps(int x, int y, double t) {
  const double whole = std::floor(t), share = t - whole;
  return (1 - share) * waves(x, y, whole) + share * waves(x, y, whole + 1);
}

struct Named {
  const char* name;
  SensorConfig config;
};
void PrintTo(const Named& sensor, std::ostream* out) {
  *out << sensor.name;
}

SensorConfig with(auto member, auto value) {
  SensorConfig config = plain();
  config.*member = value;
  return config;
}

SensorConfig withNoise(const NoiseConfig& noise) {
  return with(&SensorConfig::noise, noise);
}

class Updates : public testing::TestWithParam<Named> {};

TEST_P(Updates, AtAllPixelsGiveTheEventsOfWholeFrames) {
  UpdateRun frames(GetParam().config, kWidth, kHeight, waves),
      updates = {GetParam().config, kWidth, kHeight, waves};
  for (int i = 0; i < kIntervals; ++i) updates.updated(kParts);
  for (int i = 0; i < kIntervals * kParts; ++i) frames.whole(kParts);
  EXPECT_GT(updates.all.size(), 3000u);
  EXPECT_TRUE(alike(updates.all, frames.all));
  EXPECT_EQ(updates.suppressed, frames.suppressed);
}

INSTANTIATE_TEST_SUITE_P(
    Sensors, Updates,
    testing::Values(Named{"direct", plain()},
                    Named{"refractory", with(&SensorConfig::refractory, TimeNs(700'000))},
                    Named{"long_refractory", with(&SensorConfig::refractory, TimeNs(3'300'000))},
                    Named{"low_pass", withNoise({.photoreceptor_hz = 150})},
                    Named{"two_poles", withNoise({.photoreceptor_hz = 150, .follower_hz = 400})},
                    Named{"asymmetry", withNoise({.photoreceptor_hz = 150, .asymmetry = 1})},
                    Named{"two_asymmetric_poles",
                          withNoise({.photoreceptor_hz = 150, .follower_hz = 450, .asymmetry = 1})},
                    Named{"dark_current", withNoise({.photoreceptor_hz = 150, .dark_luminance = 0.2})},
                    Named{"level_leak", withNoise({.level_leak_hz = 40})},
                    Named{"kalman", with(&SensorConfig::reconstruction, "kalman")},
                    Named{"bias", with(&SensorConfig::bias, 0.05)},
                    Named{"mismatch", withNoise({.mismatch = 0.2})}),
    [](const auto& info) { return info.param.name; });

class StraightUpdates : public testing::TestWithParam<Named> {};

TEST_P(StraightUpdates, ChangeNothing) {
  UpdateRun without(GetParam().config, kWidth, kHeight, ramps),
      updates = {GetParam().config, kWidth, kHeight, ramps};
  for (UpdateRun* run : {&without, &updates})
    run->change.var_dI.fill(0.001f), run->change.var_I_prev.fill(0.004f);
  for (int i = 0; i < kIntervals; ++i) {
    without.whole();
    updates.updated(kParts, [](int x, int y, int k) { return (x + y + k) % 3 != 0 && x != 5; });
  }
  EXPECT_GT(updates.all.size(), 1000u);
  EXPECT_TRUE(alike(updates.all, without.all));
}

INSTANTIATE_TEST_SUITE_P(
    Sensors, StraightUpdates,
    testing::Values(Named{"direct", plain()},
                    Named{"refractory", with(&SensorConfig::refractory, TimeNs(700'000))},
                    Named{"kalman", with(&SensorConfig::reconstruction, "kalman")},
                    Named{"complementary", with(&SensorConfig::reconstruction, "complementary")},
                    Named{"mismatch", withNoise({.mismatch = 0.2})},
                    Named{"labels", with(&SensorConfig::labels, true)}),
    [](const auto& info) { return info.param.name; });

// The response to a pulse of three pieces, against the formula of photoreceptor.h by hand.
TEST(PhotoreceptorUpdates, SeeAPulseInsideTheInterval) {
  const double hz = 20, a = 2 * std::numbers::pi * hz * seconds(kInterval);
  Photoreceptor pole({.photoreceptor_hz = hz, .reference_luminance = 1e-3}, 1, 1);
  IntensityChange change(1, 1);
  change.t1 = kInterval;
  change.I_now.fill(1);
  // A rise in one quarter, a fall in the next, and rest in the last.
  Pieces pieces{};
  pieces.count = 2;
  pieces.from = {0.25f, 0.5f}, pieces.to = {0.5f, 0.75f}, pieces.dL = {1, -1}, pieces.I = {1, 1};
  pole.filter(change, pieces);
  ImageF dL(1, 1), from(1, 1);
  from.fill(0.75f);
  pole.filter(change, dL, &from);
  const double q = std::exp(-a / 4), phi = (1 - q) / (a / 4);
  EXPECT_NEAR(pieces.dL[0], 1 - phi, 1e-5);
  EXPECT_NEAR(pieces.dL[1], -1 - (q - 1) * phi + phi, 1e-5);
  EXPECT_NEAR(pieces.dL[0] + pieces.dL[1] + dL.at(0, 0), -q * (q - 1) * phi, 1e-5);
}

// E[K] = sum |dL| / C [E (31)].
TEST(ProbabilisticUpdates, GiveTheMeanOfTheirPath) {
  SensorConfig config = plain();
  config.model = "probabilistic", config.threshold = config.threshold_off = 0.2;
  constexpr int kSide = 100;
  // Up by 0.1, and down again.
  UpdateRun run(config, kSide, kSide,
                [](int, int, double t) { return 0.2 * std::abs(std::remainder(t, 1.)); });
  run.updated(2);
  const double n = kSide * kSide, on = static_cast<double>(
                                      std::ranges::count_if(run.all, [](const Event&e) { return e.p == 1; }));
  EXPECT_NEAR(on / n, 0.5, 5 * std::sqrt(0.25 / n));
  EXPECT_NEAR((static_cast<double>(run.all.size()) - on) / n, 0.5, 5 * std::sqrt(0.25 / n));
}

// 1.2 in an interval is 8 events of 0.15, and 6 of -1.2 by 0.2.
double climbs(int, int, double t) {
  return 1.2 * t;
}

TEST(UpdateBounds, HoldForAPixelAndItsInterval) {
  SensorConfig bounded = plain();
  bounded.max_events_per_pixel_frame = 3;
  UpdateRun run(bounded, kWidth, kHeight, climbs), free(plain(), kWidth, kHeight, climbs);
  for (int i = 0; i < 3; ++i) {
    run.updated(kParts), free.updated(kParts);
    EXPECT_EQ(run.out.events.size(), 3u * kWidth * kHeight);
  }
  EXPECT_EQ(run.all.size() + run.suppressed, free.all.size());
}

TEST(UpdateBounds, HoldForAllPixelsAndKeepTheFirst) {
  SensorConfig bounded = plain();
  bounded.max_events_per_frame = 100;
  UpdateRun run(bounded, kWidth, kHeight, climbs), free(plain(), kWidth, kHeight, climbs);
  for (int i = 0; i < 3; ++i) {
    run.updated(kParts), free.updated(kParts);
    EXPECT_EQ(run.out.events.size(), 100u);
    EXPECT_EQ(run.out.events.size() + run.out.suppressed, free.out.events.size());
    EXPECT_LT(run.out.events.back().t_ns, run.change.t0.count() + kInterval.count() / 8);
  }
}

TEST(UpdateThresholds, SettleBeforeTheFirstPiece) {
  SensorConfig config = plain();
  UpdateRun run(config, kWidth, kHeight, waves), frames(config, kWidth, kHeight, waves);
  run.updated(kParts);
  for (int i = 0; i < kParts; ++i) frames.whole(kParts);
  for (UpdateRun* r : {&run, &frames}) r->sensor.change({.threshold = 0.05, .threshold_off = 0.07});
  run.updated(kParts);
  for (int i = 0; i < kParts; ++i) frames.whole(kParts);
  EXPECT_TRUE(alike(run.all, frames.all));
}

TEST(DegenerateUpdates, ChangeNothing) {
  UpdateRun with(plain(), kWidth, kHeight, waves), without(plain(), kWidth, kHeight, waves);
  without.updated(4);
  with.updated(4);
  ASSERT_TRUE(alike(with.all, without.all));
  const float values[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()};
  with.change.updates.clear();
  for (std::uint32_t i = 0; i < with.pixels(); ++i) with.change.updates.push_back({i, 0.5f, values[i % 2]});
  without.change.updates.clear();
  for (UpdateRun* run : {&with, &without}) run->sensor.generate(run->change, run->out);
  // All of the change comes after the middle.
  EXPECT_EQ(with.out.events.size(), without.out.events.size());
  for (const Event& e : with.out.events) EXPECT_GE(e.t_ns, with.change.t0.count() + kInterval.count() / 2);
}

TEST(UpdateMemory, NothingAllocatesAfterTwoIntervals) {
  SensorConfig config = withNoise({.mismatch = 0.1, .photoreceptor_hz = 300});
  config.refractory = TimeNs(100'000), config.labels = true, config.reconstruction = "kalman";
  UpdateRun run(config, kWidth, kHeight, waves);
  run.updated(kParts);
  run.updated(kParts);
  for (int i = 0; i < 3; ++i) {
    run.change.t0 = run.change.t1, run.change.t1 += kInterval, ++run.change.frame;
    const int before = allocations();
    run.sensor.generate(run.change, run.out);
    EXPECT_EQ(allocations() - before, 0);
  }
}

}  // namespace
}  // namespace saccade::test
