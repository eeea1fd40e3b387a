#include "cache/bake/baked_vertex.h"

#include <gtest/gtest.h>

#include <cmath>

namespace saccade {
namespace {

// Four numbers to a power of two: half a step is an eighth of the number at most.
TEST(VarianceByte, IsTheNearestOfItsNumbers) {
  for (float v = 0x1p-47f; v < 0x1p15f; v *= 1.013f) ASSERT_NEAR(VarianceByte(v).value(), v, v / 8) << v;
  for (const float exact : {0x1p-48f, 0.5f, 0.625f, 1.f, 1.75f, 0x1.cp15f})
    EXPECT_EQ(VarianceByte(exact).value(), exact);
}

TEST(VarianceByte, IsBounded) {
  EXPECT_EQ(VarianceByte(0).value(), 0x1p-48f);
  EXPECT_EQ(VarianceByte(1e30f).value(), 0x1.cp15f);
  EXPECT_EQ(VarianceByte(INFINITY).value(), 0x1.cp15f);
}

const BakedVertex kFine{true, 0.3f, 0.7f, 0.5f, 0.25f, 2, 0.125f}, kCoarse{true, 5, 1, 1, 4, 8, 16};

void expectNear(const BakedVertex& a, const BakedVertex& b) {
  constexpr float kHalfFloat = 0x1p-11f;
  EXPECT_EQ(a.known, b.known);
  EXPECT_NEAR(a.residual, b.residual, kHalfFloat * b.residual);
  EXPECT_NEAR(a.visibility, b.visibility, kHalfFloat * b.visibility);
  EXPECT_EQ(a.var_residual, b.var_residual);
  EXPECT_EQ(a.var_visibility, b.var_visibility);
  EXPECT_EQ(a.step_residual, b.step_residual);
  EXPECT_EQ(a.step_visibility, b.step_visibility);
}

TEST(BakedPair, KeepsBothLights) {
  const BakedPair pair(kFine, kCoarse);
  expectNear(pair.fine(), kFine);
  expectNear(pair.coarse(), kCoarse);
  const BakedPair fines = BakedPair::ofFine(pair, BakedPair(kCoarse, {}));
  expectNear(fines.fine(), kFine);
  expectNear(fines.coarse(), kCoarse);
}

TEST(BakedPair, TellsWhatItDoesNotKnow) {
  EXPECT_FALSE(BakedPair().fine().known);
  const BakedPair half({}, kCoarse);
  EXPECT_FALSE(half.fine().known);
  EXPECT_TRUE(half.coarse().known);
  EXPECT_TRUE(BakedPair({.known = true, .visibility = -1e-3f}, {}).fine().known) << "of rounding errors";
}

TEST(BakedSums, AddUpByLane) {
  BakedSums sums;
  const Octet w{0.5f, 0.5f, 0.5f, 0.5f, 0.25f, 0.25f, 0.25f, 0.25f};
  sums.add(BakedPair(kFine, kCoarse), w);
  sums.add(BakedPair(kFine, {}), w);
  EXPECT_NEAR(sums.means[kResidual], 0.3f, 1e-3f);
  EXPECT_NEAR(sums.means[kVisibility], 0.7f, 1e-3f);
  EXPECT_EQ(sums.means[kKnown], 1);
  EXPECT_EQ(sums.means[kOfCoarse + kResidual], 1.25f);
  EXPECT_EQ(sums.means[kOfCoarse + kVisibility], 0.25f);
  EXPECT_EQ(sums.means[kOfCoarse + kKnown], 0.25f);
  EXPECT_EQ(sums.variances[kVarResidual], 0.5f);
  EXPECT_EQ(sums.variances[kStepVisibility], 0.125f);
  EXPECT_NEAR(sums.variances[kOfCoarse + kStepResidual], 2, 1e-6f);
}

}  // namespace
}  // namespace saccade
