// RELAX on the difference, against EventSVGF on the same samples.
#include "methods/relax.h"

#include <gtest/gtest.h>

#include "filter/synthetic.h"
#include "methods/event_svgf.h"

namespace saccade {
namespace {

constexpr int kW = 40, kH = 30;

// A standing wall. From frame `off` on it is dark.
struct Fixture : ::testing::Test {
  Fixture() { test::makeWall(a), test::makeWall(b); }
  void run(Method& method, int frames, int off) {
    draw(a, 0, off);
    method.start(a, pool);
    Frame *prev = &a, *cur = &b;
    for (int t = 1; t <= frames; ++t) {
      draw(*cur, t, off);
      method.estimate({*cur, *prev}, pool, change, times);
      std::swap(cur, prev);
    }
  }
  // Pass 1 has the numbers of the frame before.
  void draw(Frame& frame, int t, int off) {
    const float high = t < off ? 1.5f : 0, low = t < off ? 0.5f : 0;
    frame.index = static_cast<FrameIndex>(t);
    test::fillRandom(frame.samples.I1, static_cast<std::uint64_t>(t), low, high);
    test::fillRandom(frame.samples.I2, static_cast<std::uint64_t>(t + 1), low, high);
  }
  TilePool pool{1};
  Frame a{kW, kH}, b{kW, kH};
  IntensityChange change{kW, kH};
  StageTimes times;
};

TEST_F(Fixture, AStandingWallHasNoChange) {
  Relax method({}, kW, kH);
  run(method, 8, 99);
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) {
      ASSERT_EQ(change.dI.at(x, y), 0);
      ASSERT_NEAR(change.I_now.at(x, y), 1, 0.1);
    }
  }
}

// A fast history of six frames keeps 5/6 of the light that was, and its spread allows a little more. One of
// 30 frames alone keeps 29/30, and EventSVGF 9/10.
TEST_F(Fixture, FollowsALampThatGoesOffFaster) {
  Relax method({}, kW, kH), slow({.clamp = 1000}, kW, kH);
  EventSvgf event_svgf({}, kW, kH);
  run(slow, 32 + 2, 32);
  EXPECT_NEAR(change.I_now.at(20, 15), std::pow(29 / 30., 3), 0.03);
  run(event_svgf, 32 + 2, 32);
  EXPECT_NEAR(change.I_now.at(20, 15), std::pow(0.9, 3), 0.03);
  run(method, 32 + 2, 32);
  EXPECT_NEAR(change.I_now.at(20, 15), std::pow(5 / 6., 3), 0.1);
}

}  // namespace
}  // namespace saccade
