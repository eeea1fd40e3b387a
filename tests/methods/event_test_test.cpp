#include "methods/event_test.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

// Quantiles from tables of Student's distribution.
TEST(EventTest, KnowsStudentsDistribution) {
  for (const auto& [freedom, t] : {std::pair{3.f, 3.182f}, {5, 2.571f}, {10, 2.228f}, {30, 2.042f}})
    EXPECT_NEAR(tQuantile(freedom), t, 0.01f * t) << freedom;
}

TEST(EventTest, MeansHaveTheVarianceOfTheirSamples) {
  const BrightnessMean mean = BrightnessMean::of(1 + 2 + 3 + 6, 1 + 4 + 9 + 36, 4);
  EXPECT_FLOAT_EQ(mean.mean, 3);
  EXPECT_FLOAT_EQ(mean.variance, (4 + 1 + 0 + 9) / 3.f / 4);
  EXPECT_EQ(BrightnessMean::of(2, 4, 1).variance, 0);
}

// With equal variances and numbers n, Welch's degrees of freedom are 2 n - 2.
TEST(EventTest, IsCertainBeyondTheQuantile) {
  const auto at = [](float mean) { return BrightnessMean{mean, 0.5e-4f, 6}; };  // together 0.01^2
  const float t = 2.228f * 0.01f;                                               // of 10 degrees of freedom
  for (const float side : {-1.f, 1.f}) {
    EXPECT_TRUE(testEvent(at(side * (0.2f + 1.02f * t)), at(0), 0.2f).certain);
    EXPECT_FALSE(testEvent(at(side * (0.2f + 0.98f * t)), at(0), 0.2f).certain);
    EXPECT_FALSE(testEvent(at(side * (0.2f - 0.98f * t)), at(0), 0.2f).certain);
    EXPECT_TRUE(testEvent(at(side * (0.2f - 1.02f * t)), at(0), 0.2f).certain);
    EXPECT_TRUE(testEvent(at(side * 0.21f), at(0), 0.2f).event);
    EXPECT_FALSE(testEvent(at(side * 0.19f), at(0), 0.2f).event);
  }
}

}  // namespace
}  // namespace saccade
