// RELAX on the difference, against EventSVGF on the same samples.
#include "methods/relax.h"

#include <gtest/gtest.h>

#include <cmath>

#include "methods/event_svgf.h"
#include "methods/switched_wall.h"

namespace saccade {
namespace {

using namespace test;

class RelaxTest : public SwitchedWall {};

TEST_F(RelaxTest, AStandingWallHasNoChange) {
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
TEST_F(RelaxTest, FollowsALampThatGoesOffFaster) {
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
