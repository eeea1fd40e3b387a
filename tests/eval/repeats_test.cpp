#include "eval/metrics/repeats.h"

#include <gtest/gtest.h>

#include <cmath>

#include "eval/planes.h"

namespace saccade::eval {
namespace {

using test::plane;

TEST(Repeats, KnowMeanAndSpreadOfEachPixel) {
  Repeats repeats(2, 1);
  for (const ImageF& x : {plane({1, 5}), plane({2, 5}), plane({6, 5})}) repeats.add(x);
  EXPECT_EQ(repeats.count(), 3);
  EXPECT_DOUBLE_EQ(repeats.mean(0, 0), 3);
  EXPECT_DOUBLE_EQ(repeats.variance(0, 0), (4 + 1 + 9) / 2.0);
  EXPECT_FLOAT_EQ(repeats.sigma().at(0, 0), std::sqrt(7.f));
  EXPECT_EQ(repeats.mean(1, 0), 5);
  EXPECT_EQ(repeats.variance(1, 0), 0);
}

// The values are 4096 +- 2^-11. A float can hold them, but not their squares.
TEST(Repeats, LoseNothingOfSmallNoiseOnALargeMean) {
  Repeats repeats(1, 1);
  const float noise = 0x1p-11f;
  for (int i = 0; i < 1000; ++i) repeats.add(plane({4096 + (i % 2 ? noise : -noise)}));
  EXPECT_NEAR(repeats.variance(0, 0) / (noise * noise), 1000.0 / 999, 1e-6);
}

TEST(Repeats, NeedTwoForASpread) {
  Repeats repeats(1, 1);
  repeats.add(plane({1}));
  EXPECT_DEATH(repeats.variance(0, 0), "count_ >= 2");
}

}  // namespace
}  // namespace saccade::eval
