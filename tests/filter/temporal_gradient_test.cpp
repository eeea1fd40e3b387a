#include "filter/temporal_gradient.h"

#include <gtest/gtest.h>

#include "filter/synthetic.h"
#include "frame/pixel_before.h"

namespace saccade {
namespace {

constexpr int kW = 40, kH = 30;

// A wall that moves by two pixels, under noisy light that is `ratio` times that of the frame before.
struct Fixture : ::testing::Test {
  Fixture() {
    for (Frame* f : {&cur, &prev}) test::makeWall(*f);
    test::fillInside(cur.g.motion_x, -2);
    test::fillRandom(prev.samples.I2, 1, 0.2f, 1.8f);
    cur.index = 1;
  }
  void light(float ratio, int from_x = 0) {
    for (int y = 0; y < kH; ++y) {
      for (int x = 0; x < kW; ++x) {
        const PixelPlace p = pixelBefore(cur.g, x, y);
        cur.samples.I1.at(x, y) = (x < from_x ? 1 : ratio) * prev.samples.I2.at(p.x, p.y);
      }
    }
  }
  TilePool pool{2};
  Frame cur{kW, kH}, prev{kW, kH};
  TemporalGradient gradient{kW, kH, 3};
};

TEST_F(Fixture, SteadyLightHasNoneThroughItsNoise) {
  light(1);
  gradient.estimate({cur, prev}, pool);
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) ASSERT_EQ(gradient.change(x, y), 0);
  }
}

// lambda = |2 i - i| / max(2 i, i) and |0 - i| / max(0, i), whatever the weights of the filter.
TEST_F(Fixture, IsTheShareOfTheLightThatChanges) {
  for (const auto& [ratio, share] : {std::pair{2.f, 0.5f}, {0.f, 1.f}, {0.75f, 0.25f}}) {
    light(ratio);
    gradient.estimate({cur, prev}, pool);
    for (int x = 0; x < kW; ++x) EXPECT_NEAR(gradient.change(x, 15), share, 1e-5f);
  }
}

TEST_F(Fixture, StopsAtEdgesOfTheSurface) {
  constexpr int kEdge = 21;  // between strata
  for (Frame* f : {&cur, &prev}) {
    for (int y = 0; y < kH; ++y) {
      for (int x = f == &cur ? kEdge : kEdge - 2; x < kW; ++x) f->g.nz.at(x, y) = 0, f->g.nx.at(x, y) = -1;
    }
  }
  light(0, kEdge);
  gradient.estimate({cur, prev}, pool);
  EXPECT_LT(gradient.change(kEdge - 1, 15), 1e-6f);
  EXPECT_FLOAT_EQ(gradient.change(kEdge, 15), 1);
}

TEST_F(Fixture, ASurfaceThatAppearsHasNone) {
  test::fillInside(prev.g.z, 1);
  light(0);
  gradient.estimate({cur, prev}, pool);
  EXPECT_EQ(gradient.change(20, 15), 0);
  const FramePair first = FramePair::first(cur);
  gradient.estimate(first, pool);
  EXPECT_EQ(gradient.change(20, 15), 0);
}

TEST(PixelBefore, StaysInThePicture) {
  Frame frame(4, 3);
  frame.g.motion_x.fill(-9), frame.g.motion_y.fill(1.4f);
  EXPECT_EQ(pixelBefore(frame.g, 2, 0).x, 0);
  EXPECT_EQ(pixelBefore(frame.g, 2, 0).y, 1);
  EXPECT_EQ(pixelBefore(frame.g, 2, 2).y, 2);
}

}  // namespace
}  // namespace saccade
