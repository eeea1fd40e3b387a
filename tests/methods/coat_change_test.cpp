#include "methods/coat_change.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/hash_rng.h"
#include "base/tile_pool.h"

namespace saccade {
namespace {

constexpr int kW = 40, kH = 32, kOthers = 8;  // the first columns show no coat
constexpr float kNoise = 0.1f;                // standard deviation of a pair's light
constexpr float kPairedNoise = 0.01f;         // of its difference
constexpr float kBase = 3, kBaseChange = 0.5f;

// A wall that a camera sees from the front. Its coat reflects `light`, which changes.
struct CoatChangeTest : testing::Test {
  CoatChangeTest() {
    for (Frame* f : {&cur, &prev}) {
      f->g.z.fill(1), f->g.z_in_prev.fill(1), f->g.dz.fill(0.01f);
      for (int y = 0; y < kH; ++y) std::fill_n(f->g.nz.row(y), kW, 1.f);
      f->g.albedo.fill(0.5f);
    }
    cur.coats = std::make_unique<CoatSamples>(kW, kH);
  }

  // With a standard deviation of 1.
  float errorAt(int x, int y, std::uint64_t of) const {
    constexpr float kSqrt12 = 3.4641f;  // of evenly distributed numbers
    return kSqrt12 * (toUnit(hashKey(2 * frame + of, y * kW + x)) - 0.5f);
  }
  // A frame whose true change is `d`.
  void step(float d, bool noise = true) {
    PairSamples& pairs = cur.coats->pairs;
    for (int y = 0; y < kH; ++y)
      for (int x = kOthers; x < kW; ++x) {
        pairs.before.at(x, y) = light + (noise ? kNoise * errorAt(x, y, 0) : 0);
        cur.coats->now.at(x, y) = pairs.before.at(x, y) + d + (noise ? kPairedNoise * errorAt(x, y, 1) : 0);
        pairs.variance.at(x, y) = noise ? kPairedNoise * kPairedNoise : 0, pairs.count.at(x, y) = 1;
      }
    ++frame, light += d;
    change.dI.fill(kBaseChange), change.I_prev.fill(kBase), change.I_now.fill(kBase + kBaseChange);
    estimator.addTo(change, {cur, prev}, pool, times);
  }
  // Root mean square error of a plane over the pixels with a coat.
  double rms(const ImageF& plane, float truth) const {
    double sum = 0;
    for (int y = 0; y < kH; ++y)
      for (int x = kOthers; x < kW; ++x) sum += std::pow(plane.at(x, y) - truth, 2);
    return std::sqrt(sum / (kH * (kW - kOthers)));
  }

  TilePool pool{2};
  StageTimes times;
  Frame cur{kW, kH}, prev{kW, kH};
  IntensityChange change{kW, kH};
  CoatChange estimator{kW, kH};
  float light = 1;
  std::uint64_t frame = 0;
};

TEST_F(CoatChangeTest, AddsToWhatTheBaseReflects) {
  step(0.25f, false);
  EXPECT_LT(rms(change.dI, kBaseChange + 0.25f), 1e-5);
  EXPECT_LT(rms(change.I_prev, kBase + 1), 1e-5);
  EXPECT_LT(rms(change.I_now, kBase + kBaseChange + 1.25f), 1e-5);
}

TEST_F(CoatChangeTest, OtherPixelsStayAsTheyAre) {
  step(0.25f);
  for (int y = 0; y < kH; ++y) {
    EXPECT_EQ(change.dI.at(kOthers - 1, y), kBaseChange);
    EXPECT_EQ(change.I_prev.at(kOthers - 1, y), kBase);
  }
}

TEST_F(CoatChangeTest, EqualPairsHaveNoChange) {
  for (int t = 0; t < 3; ++t) step(0, false);
  EXPECT_EQ(rms(change.dI, kBaseChange), 0);
}

// Light before is what the frame before has found, and what this frame's pairs tell of it.
TEST_F(CoatChangeTest, LightGathersOverFrames) {
  step(0);
  const double first = rms(change.I_prev, kBase + 1);
  for (int t = 0; t < 10; ++t) step(0);
  EXPECT_LT(rms(change.I_prev, kBase + 1), 0.8 * first);
}

TEST_F(CoatChangeTest, LightFollowsItsChange) {
  for (int t = 0; t < 10; ++t) step(0.2f);
  const float before = light;
  step(-0.3f);
  EXPECT_LT(rms(change.I_prev, kBase + before), 0.8 * kNoise);
  EXPECT_LT(rms(change.dI, kBaseChange - 0.3f), 0.8 * kNoise);
}

TEST_F(CoatChangeTest, ForgetsWhatItIsToldTo) {
  step(0);
  const double first = rms(change.I_prev, kBase + 1);
  for (int t = 0; t < 10; ++t) step(0);
  estimator.forget();
  frame = 0;  // the same noise as at first
  step(0);
  EXPECT_EQ(rms(change.I_prev, kBase + 1), first);
}

}  // namespace
}  // namespace saccade
