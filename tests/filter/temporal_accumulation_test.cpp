#include "filter/temporal_accumulation.h"

#include <gtest/gtest.h>

#include "filter/reprojection.h"
#include "filter/surface_test.h"
#include "filter/synthetic.h"

namespace saccade {
namespace {

using test::fillInside;
using test::fillRandom;
constexpr int kW = 41, kH = 23;

Reprojection look(const FramePair& frames, int x, int y) {
  const GBuffer &g = frames.cur.g, &g_prev = frames.prev.g;
  return Reprojection::find(g, g_prev, x, y, SameSurface(g, g_prev, x, y));
}

// W v for every pixel, by the definition of the taps.
void warp(const FramePair& frames, const ImageF& v, ImageF& out) {
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) out.at(x, y) = look(frames, x, y)(v);
  }
}

struct Fixture : ::testing::Test {
  Fixture() {
    for (Frame* f : {&cur, &prev, &older}) test::makeWall(*f);
    // Any motion, inside the picture: half a pixel and more, different everywhere and in both frames.
    for (Frame* f : {&cur, &prev}) {
      fillRandom(f->g.motion_x, f == &cur ? 1 : 2, -1.3f, 1.3f);
      fillRandom(f->g.motion_y, f == &cur ? 3 : 4, -1.3f, 1.3f);
    }
  }
  TilePool pool{2};
  Frame cur{kW, kH}, prev{kW, kH}, older{kW, kH};
  History now{kW, kH}, before{kW, kH};
  IlluminationSamples samples{kW, kH};
  ImageF I_prev2{kW, kH};
};

// With one alpha, Eq. 16 is Eq. 13 minus Eq. 14 for any data and any motion.
TEST_F(Fixture, DifferenceEqualsThatOfThePrimalsAtConstantAlpha) {
  const float alpha = 0.5f;
  ImageF i_prev(kW, kH);
  fillRandom(i_prev, 10);
  fillRandom(samples.i, 11);
  fillRandom(I_prev2, 12);
  // Frame t-1, written out: R = W I'_{t-2}; I' = alpha i + (1 - alpha) R; D' = I' - I'_{t-2}.
  warp({prev, older}, I_prev2, before.R);
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) {
      before.I.at(x, y) = alpha * i_prev.at(x, y) + (1 - alpha) * before.R.at(x, y);
      before.D.at(x, y) = before.I.at(x, y) - I_prev2.at(x, y);
      samples.d.at(x, y) = samples.i.at(x, y) - i_prev.at(x, y);
    }
  }
  fillInside(before.length, 8);

  accumulate({cur, prev}, samples, {.alpha = alpha}, before, &I_prev2, pool, now);
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) {
      if (!look({cur, prev}, x, y).found()) continue;
      EXPECT_NEAR(now.D.at(x, y), now.I.at(x, y) - before.I.at(x, y), 2e-6f) << x << "," << y;
    }
  }
}

TEST_F(Fixture, WithoutCorrectionItDoesNot) {
  fillRandom(I_prev2, 12);
  fillRandom(before.R, 13);
  fillInside(before.length, 8);
  accumulate({cur, prev}, samples, {.correct_difference = false}, before, &I_prev2, pool, now);
  EXPECT_EQ(now.D.at(20, 10), 0);
  accumulate({cur, prev}, samples, {}, before, &I_prev2, pool, now);
  EXPECT_NE(now.D.at(20, 10), 0);
}

TEST_F(Fixture, LostHistoryStartsAnew) {
  fillRandom(samples.i, 11);
  fillRandom(samples.d, 12, -1, 1);
  fillRandom(before.I, 13);
  fillRandom(before.D, 14);
  fillInside(before.length, 8);
  cur.g.z_in_prev.at(7, 5) = 9;                  // was hidden behind the wall
  cur.g.motion_x.at(8, 5) = 1000;                // was outside
  cur.g.nx.at(9, 5) = 1, cur.g.nz.at(9, 5) = 0;  // another face
  accumulate({cur, prev}, samples, {}, before, &I_prev2, pool, now);
  for (int x : {7, 8, 9}) {
    EXPECT_EQ(now.length.at(x, 5), 1);
    EXPECT_EQ(now.I.at(x, 5), samples.i.at(x, 5));
    EXPECT_EQ(now.D.at(x, 5), samples.d.at(x, 5));
    EXPECT_EQ(now.m2.at(x, 5), samples.i.at(x, 5) * samples.i.at(x, 5));
  }
  EXPECT_EQ(now.length.at(20, 10), 9);
}

TEST_F(Fixture, TheDifferenceNeedsHistoryInBothFrames) {
  fillRandom(samples.d, 12, -1, 1);
  fillInside(before.length, 8);
  before.length.at(20, 10) = 1;  // this pixel saw a new surface one frame ago
  accumulate({cur, prev}, samples, {}, before, &I_prev2, pool, now);
  EXPECT_EQ(now.D.at(20, 10), samples.d.at(20, 10));
}

TEST_F(Fixture, MotionFollowsTheSurface) {
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x)
      before.I.at(x, y) = static_cast<float>(10 * x + y);  // linear: bilinear is exact
  }
  fillInside(before.length, 8);
  fillInside(cur.g.motion_x, 1.25f);
  fillInside(cur.g.motion_y, -0.5f);
  accumulate({cur, prev}, samples, {}, before, &I_prev2, pool, now);
  EXPECT_NEAR(now.R.at(20, 10), 10 * 21.25f + 9.5f, 1e-4f);
}

// Failing its own four taps, a pixel takes the mean of what its neighbours know of the surface.
TEST_F(Fixture, LooksAroundWhereItsOwnTapsAreOfAnotherSurface) {
  fillInside(before.length, 8);
  fillInside(before.I, 0.25f);
  fillInside(cur.g.motion_x, 0);
  fillInside(cur.g.motion_y, 0);
  prev.g.z.at(20, 10) = 9;
  before.I.at(20, 10) = 100;
  accumulate({cur, prev}, samples, {}, before, &I_prev2, pool, now);
  EXPECT_NEAR(now.R.at(20, 10), 0.25f, 1e-6f);
  EXPECT_EQ(now.length.at(20, 10), 9);
}

TEST_F(Fixture, WithoutHistoryOfTwoFramesOnlyThePrimalIsAccumulated) {
  fillRandom(samples.i, 11);
  fillRandom(before.I, 13);
  fillInside(before.length, 8);
  accumulate({cur, prev}, samples, {}, before, &I_prev2, pool, now);
  History alone(kW, kH);
  accumulate({cur, prev}, samples, {}, before, nullptr, pool, alone);
  EXPECT_EQ(alone.I.at(20, 10), now.I.at(20, 10));
  EXPECT_EQ(alone.m2.at(20, 10), now.m2.at(20, 10));
}

// Falcor's faults, which no other test has.
TEST_F(Fixture, FalcorLosesTheHistoryOfAFastDollyAndOfTheFirstColumn) {
  fillInside(before.length, 8);
  fillInside(cur.g.motion_x, 0);
  fillInside(cur.g.motion_y, 0);
  accumulate({cur, prev}, samples, {.surface_test = SurfaceTest::kFalcorSurface}, before, nullptr, pool, now);
  EXPECT_EQ(now.length.at(0, 5), 1);
  EXPECT_EQ(now.length.at(5, 5), 9);
  fillInside(cur.g.z, 4.5f);  // half a unit nearer than the frame before saw it
  accumulate({cur, prev}, samples, {.surface_test = SurfaceTest::kFalcorSurface}, before, nullptr, pool, now);
  EXPECT_EQ(now.length.at(5, 5), 1);
  accumulate({cur, prev}, samples, {}, before, nullptr, pool, now);
  EXPECT_EQ(now.length.at(5, 5), 9);
  EXPECT_EQ(now.length.at(0, 5), 9);
}

}  // namespace
}  // namespace saccade
