#include "methods/paired_change.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/hash_rng.h"
#include "base/tile_pool.h"

namespace saccade {
namespace {

constexpr int kW = 40, kH = 32, kOthers = 8;  // the first columns have no pairs
constexpr float kNoise = 0.1f;                // standard deviation of a pair's difference

// A wall that a camera sees from the front, and whose light of 1 changes.
struct PairedChangeTest : testing::Test {
  PairedChangeTest() {
    for (Frame* f : {&cur, &prev}) {
      f->g.z.fill(1), f->g.z_in_prev.fill(1), f->g.dz.fill(0.01f);
      for (int y = 0; y < kH; ++y) std::fill_n(f->g.nz.row(y), kW, 1.f);
      f->g.albedo.fill(1);
      f->pairs = std::make_unique<PairSamples>(kW, kH);
    }
    change.I_prev.fill(1);
  }

  // A frame whose true change is `d`. Returns the mean of its estimates over the pixels with pairs.
  double step(float d, float noise = kNoise) {
    constexpr float kSqrt12 = 3.4641f;  // of evenly distributed numbers
    for (int y = 0; y < kH; ++y)
      for (int x = 0; x < kW; ++x) {
        const float error = noise * kSqrt12 * (toUnit(hashKey(frame, y * kW + x)) - 0.5f);
        cur.pairs->before.at(x, y) = 1, cur.samples.I2.at(x, y) = 1 + d + error;
        cur.pairs->variance.at(x, y) = noise * noise, cur.pairs->count.at(x, y) = x < kOthers ? 0 : 1;
        change.dI.at(x, y) = d, change.I_now.at(x, y) = 1 + d;
      }
    ++frame;
    estimator.estimate({cur, prev}, pool, change, times);
    double sum = 0;
    for (int y = 0; y < kH; ++y)
      for (int x = kOthers; x < kW; ++x) sum += change.dI.at(x, y);
    return sum / (kH * (kW - kOthers));
  }
  double rms(float d) const {
    double sum = 0;
    for (int y = 0; y < kH; ++y)
      for (int x = kOthers; x < kW; ++x) sum += std::pow(change.dI.at(x, y) - d, 2);
    return std::sqrt(sum / (kH * (kW - kOthers)));
  }

  TilePool pool{2};
  StageTimes times;
  Frame cur{kW, kH}, prev{kW, kH};
  IntensityChange change{kW, kH};
  PairedChange estimator{kW, kH};
  std::uint64_t frame = 0;
};

TEST_F(PairedChangeTest, EqualPairsHaveNoChange) {
  for (int t = 0; t < 3; ++t) step(0, 0);
  EXPECT_EQ(rms(0), 0);
}

TEST_F(PairedChangeTest, SteadyChangesGatherOverFrames) {
  step(0.2f);
  const double first = rms(0.2f);
  EXPECT_LT(first, 0.4 * kNoise);
  for (int t = 0; t < 10; ++t) step(0.2f);
  EXPECT_LT(rms(0.2f), 0.8 * first);
}

TEST_F(PairedChangeTest, NewChangesDoNotLag) {
  for (int t = 0; t < 10; ++t) step(0.2f);
  EXPECT_NEAR(step(-0.3f), -0.3, 0.03);
}

TEST_F(PairedChangeTest, ForgetsWhatItIsToldTo) {
  step(0.2f);
  const double first = rms(0.2f);
  for (int t = 0; t < 10; ++t) step(0.2f);
  estimator.forget();
  frame = 0;  // the same noise as at first
  step(0.2f);
  EXPECT_EQ(rms(0.2f), first);
}

// A texture that moves is known without noise: it is neither smoothed nor doubted.
TEST_F(PairedChangeTest, TexturesAreNotSmoothed) {
  const auto albedo = [](int x, int y) { return (x + y) % 2 == 0 ? 0.2f : 0.8f; };
  for (int y = 0; y < kH; ++y)
    for (int x = 0; x < kW; ++x) {
      cur.g.albedo.at(x, y) = albedo(x, y), prev.g.albedo.at(x, y) = albedo(x + 1, y);
      change.I_prev.at(x, y) = prev.g.albedo.at(x, y);
      cur.pairs->before.at(x, y) = prev.g.albedo.at(x, y), cur.samples.I2.at(x, y) = albedo(x, y);
      cur.pairs->variance.at(x, y) = kNoise * kNoise, cur.pairs->count.at(x, y) = 1;
    }
  estimator.estimate({cur, prev}, pool, change, times);
  for (int y = 0; y < kH; ++y)
    for (int x = 0; x < kW; ++x) EXPECT_NEAR(change.dI.at(x, y), albedo(x, y) - albedo(x + 1, y), 1e-5);
}

TEST_F(PairedChangeTest, OtherPixelsStayAsTheyAre) {
  step(0.2f);
  for (int y = 0; y < kH; ++y) {
    EXPECT_EQ(change.dI.at(kOthers - 1, y), 0.2f);
    EXPECT_EQ(change.I_prev.at(kOthers - 1, y), 1);
  }
}

}  // namespace
}  // namespace saccade
