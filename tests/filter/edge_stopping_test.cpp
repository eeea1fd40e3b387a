#include "filter/edge_stopping.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

TEST(FastExp2, IsWithinAThirdOfAPercent) {
  for (float x = 0; x > -100; x -= 0.0137f) EXPECT_NEAR(fastExp2(x) / std::exp2(x), 1, 3.5e-3) << x;
}

TEST(FastExp2, IsExactAtWholeNumbersAndNeverNegative) {
  EXPECT_EQ(fastExp2(0), 1);
  EXPECT_EQ(fastExp2(-1), 0.5f);
  EXPECT_EQ(fastExp2(-1e6f), 0x1p-126f);
}

TEST(DepthFactor, DoesNotStopAWallSeenHeadOn) {
  const float rounding = 1e-6f;  // of a depth of 5
  EXPECT_LT(rounding * depthFactor(1, 5, 0, kLeastSlope), 0.01f);
  EXPECT_GT(0.05f * depthFactor(1, 5, 0, kLeastSlope), 50);  // an edge of a hundredth of the depth does
  EXPECT_GT(rounding * depthFactor(1, 5, 0, kFalcorLeastSlope), 50);  // Falcor's floor is none
}

}  // namespace
}  // namespace saccade
