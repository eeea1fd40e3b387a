// A-SVGF against SVGF on the same samples.
#include "methods/a_svgf.h"

#include <gtest/gtest.h>

#include "methods/switched_wall.h"

namespace saccade {
namespace {

using namespace test;

constexpr int kOff = 20;

class ASvgfTest : public SwitchedWall {};

TEST_F(ASvgfTest, InSteadyLightItIsSvgf) {
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
TEST_F(ASvgfTest, ForgetsALampThatGoesOff) {
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
