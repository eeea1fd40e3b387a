// A-SVGF against SVGF on the same samples.
#include "methods/a_svgf.h"

#include <gtest/gtest.h>

#include "filter/synthetic.h"

namespace saccade {
namespace {

constexpr int kW = 40, kH = 30, kOff = 20;

// A standing wall. From frame `off` on it is dark.
struct Fixture : ::testing::Test {
  Fixture() { test::makeWall(a), test::makeWall(b); }
  void run(Method& method, int frames, int off) {
    std::swap(a, b);
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

TEST_F(Fixture, InSteadyLightItIsSvgf) {
  Svgf svgf({}, kW, kH);
  run(svgf, 8, 99);
  IntensityChange by_svgf(kW, kH);
  by_svgf.copyFrom(change);
  ASvgf a_svgf({}, kW, kH);
  run(a_svgf, 8, 99);
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) ASSERT_EQ(change.dI.at(x, y), by_svgf.dI.at(x, y)) << x << "," << y;
  }
}

// The paper's claim: no light remains of a lamp that goes off. SVGF forgets it by its alpha of 0.1.
TEST_F(Fixture, ForgetsALampThatGoesOff) {
  Svgf svgf({}, kW, kH);
  run(svgf, kOff, kOff);
  EXPECT_NEAR(change.I_now.at(20, 15), 0.9f, 0.05f);
  ASvgf a_svgf({}, kW, kH);
  run(a_svgf, kOff, kOff);
  EXPECT_NEAR(change.I_now.at(20, 15), 0, 1e-6f);
  EXPECT_NEAR(change.dI.at(20, 15), -1, 0.05f);
}

}  // namespace
}  // namespace saccade
