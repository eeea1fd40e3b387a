// Where the grid wants shadow rays.
#include "cache/grid/ray_visibility.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

// Evidence of visibility at ten samples: of detail, and of its noise.
Octet evidence(float detail, float noise) {
  return Octet{0, 0, 0, 10, 10 * detail, 100 * noise * noise, 0, 10};
}

TEST(ShadowVariance, IsThatOfProvenDetailAndOfTheMean) {
  EXPECT_NEAR(shadowVariance(evidence(0.04f, 0), 0.01f, 1, 1), 0.05f, 1e-4f);
  EXPECT_NEAR(shadowVariance(evidence(0.04f, 0.02f), 0.01f, 1, 1), 0.04f, 1e-4f);
  EXPECT_EQ(shadowVariance(evidence(0.04f, 0.2f), 0, 1, 1), 0);
}

TEST(ShadowVariance, IsNothingWhereItIsNoVisiblePartOfTheLight) {
  EXPECT_GT(shadowVariance(evidence(0.01f, 0), 0, 1, 1.9f), 0);
  EXPECT_EQ(shadowVariance(evidence(0.01f, 0), 0, 1, 2.1f), 0);
}

// Samples that have not met a strong lamp behind a wall know nothing of its shadow, and have no noise.
TEST(ShadowVariance, LeavesDoubtWhereLittleOfTheLightArrives) {
  EXPECT_GT(shadowVariance(evidence(0, 0), 0, 1000, 1), 0);
  EXPECT_EQ(shadowVariance(evidence(0, 0), 0, 1, 1), 0);
}

TEST(ShadowVariance, IsLargeWhereNothingIsKnown) {
  EXPECT_GT(shadowVariance(Octet{}, 0, 1, 1), 0.01f);
  EXPECT_GT(shadowVariance(evidence(0, 0), 0, 1, 0), 0.01f);
}

}  // namespace
}  // namespace saccade
