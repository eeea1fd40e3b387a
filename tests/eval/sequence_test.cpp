#include "eval/bench/sequence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "eval/changes.h"

namespace saccade::eval {
namespace {

constexpr double kBias = 0.5;
const SensorConfig kDirect{.threshold = 0.1, .threshold_off = 0.1, .bias = kBias, .reconstruction = "direct"};

// Pixel 0 rises by 0.03 in each frame, and pixel 1 falls by 0.01.
std::vector<IntensityChange> ramps(int count) {
  return test::frames(count, 2, 1, kBias, [](int, int x, int) { return x == 0 ? 0.03 : -0.01; });
}

TEST(Brightness, IsSummedFromWhereThePixelStarts) {
  const auto changes = ramps(3);
  const BrightnessSequence L = brightnessOf(test::sequence(changes), kDirect);
  for (int x = 0; x < 2; ++x) {
    const std::vector<double> series = L.at(x, 0);
    ASSERT_EQ(series.size(), 4u);
    for (int t = 0; t <= 3; ++t)
      EXPECT_NEAR(series[static_cast<std::size_t>(t)], std::log(1.5) + t * (x == 0 ? 0.03 : -0.01), 1e-6);
  }
}

// The primal stands still. e = (1 - k)(e + 0.03) converges to 0.03 (1 - k) / k.
TEST(Brightness, IsReconstructedAsASensorDoes) {
  SensorConfig complementary = kDirect;
  complementary.reconstruction = "complementary";
  complementary.reconstruction_cutoff_hz = 10;
  const auto changes = ramps(100);
  const double k = 1 - std::exp(-2 * std::numbers::pi * 10 / test::kFrameRateHz);
  const double L = brightnessOf(test::sequence(changes), complementary).at(0, 0).back();
  EXPECT_NEAR(L, std::log(1.5) + 0.03 * (1 - k) / k, 1e-4);
}

TEST(EventsOf, AreThoseOfAllFrames) {
  const auto changes = ramps(100);  // 3 and -1 in all: 30 ON, 10 OFF, and one more or less by the phase
  int on = 0, off = 0;
  for (const Event& e : eventsOf(test::sequence(changes), kDirect)) {
    EXPECT_EQ(e.p, e.x == 0);
    ++(e.p ? on : off);
  }
  EXPECT_NEAR(on, 30, 1);
  EXPECT_NEAR(off, 10, 1);
}

}  // namespace
}  // namespace saccade::eval
