#include "base/recent_mean.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

TEST(RecentMean, IsTheMeanAtFirstAndForgetsLater) {
  RecentMean mean;
  EXPECT_EQ(mean.value(), 0);
  for (const double value : {1, 2, 6}) mean.add(value);
  EXPECT_DOUBLE_EQ(mean.value(), 3);
  for (int i = 0; i < 1000; ++i) mean.add(5);
  EXPECT_NEAR(mean.value(), 5, 1e-9);
  mean.add(21);
  EXPECT_NEAR(mean.value(), 6, 1e-9);  // 5 + (21 - 5) / 16
}

}  // namespace
}  // namespace saccade
