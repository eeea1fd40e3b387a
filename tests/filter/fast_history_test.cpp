#include "filter/fast_history.h"

#include <gtest/gtest.h>

#include "filter/synthetic.h"

namespace saccade {
namespace {

constexpr int kW = 20, kH = 12;

struct Fixture : ::testing::Test {
  Fixture() { test::makeWall(cur), test::makeWall(prev); }
  TilePool pool{1};
  Frame cur{kW, kH}, prev{kW, kH};
  IlluminationSamples samples{kW, kH};
  History history{kW, kH};
  FastHistory fast{kW, kH}, fast_prev{kW, kH};
};

// A mean of at most 6 frames: 10 frames of 1, then one of 0 leaves 5/6. Its difference is that of both means.
TEST_F(Fixture, IsAMeanOfFewFrames) {
  ImageF I_prev2(kW, kH), length_prev(kW, kH);
  for (int t = 1; t <= 12; ++t) {
    samples.i.fill(t <= 10 ? 1 : 0), samples.d.fill(t == 11 ? -1 : 0);
    length_prev.copyFrom(history.length);
    history.length.fill(static_cast<float>(t));
    std::swap(I_prev2, fast_prev.I), std::swap(fast, fast_prev);
    accumulateFast({cur, prev}, samples, 6, history.length, length_prev, fast_prev, I_prev2, pool, fast);
    if (t < 11) continue;
    const float mean = t == 11 ? 5 / 6.f : 25 / 36.f;
    EXPECT_FLOAT_EQ(fast.I.at(5, 5), mean);
    EXPECT_NEAR(fast.D.at(5, 5), mean - fast_prev.I.at(5, 5), 1e-6f);
  }
}

// In stripes of 0 and 1 the 25 pixels around an even column have 10 of 1: mean 0.4, variance 0.24.
TEST_F(Fixture, ClampsTheSlowHistory) {
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) fast.I.at(x, y) = static_cast<float>(x % 2);
  }
  for (const float value : {-9.f, 0.5f, 9.f}) {
    test::fillInside(history.I, value);
    test::fillInside(history.D, value);
    clampHistory(fast, 2, pool, history);
    const float reach = 2 * std::sqrt(0.24f);
    EXPECT_NEAR(history.I.at(6, 6), std::clamp(value, 0.4f - reach, 0.4f + reach), 1e-6f);
    EXPECT_EQ(history.D.at(6, 6), 0) << "nothing changes anywhere around";
  }
}

}  // namespace
}  // namespace saccade
