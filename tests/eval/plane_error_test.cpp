#include "eval/metrics/plane_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "eval/planes.h"

namespace saccade::eval {
namespace {

using test::plane;

TEST(RelativeL1, IsTheErrorOverTheSize) {
  EXPECT_DOUBLE_EQ(relativeL1(plane({1, -1, 0, 3}), plane({1, 1, -1, 1})), 5.0 / 4);
  EXPECT_EQ(relativeL1(plane({2, -3}), plane({2, -3})), 0);
  EXPECT_EQ(relativeL1(plane({0, 0}), plane({2, -3})), 1);  // saying nothing costs 1
}

// mean |ref| is 2, so that 0.02 is added to every |ref|.
TEST(Mape, WeighsEachPixelByItsOwnTruth) {
  const double expected = (1 / (4 + 0.02) + 0.02 / (0 + 0.02) + 0 + 4 / (2 + 0.02)) / 4;
  EXPECT_NEAR(mape(plane({5, 0.02f, 2, 2}), plane({4, 0, 2, -2})), expected, 1e-7);
}

TEST(PlaneErrors, AreNothingOrInfiniteWhereTheTruthIsNothing) {
  for (auto* error : {relativeL1, mape}) {
    EXPECT_EQ(error(plane({0, 0}), plane({0, 0})), 0);
    EXPECT_EQ(error(plane({0, 1}), plane({0, 0})), std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(error(plane({0, NAN}), plane({0, 0}))));
    EXPECT_TRUE(std::isnan(error(plane({0, NAN}), plane({0, 1}))));
  }
}

TEST(PlaneErrors, AreIndependentOfTheUnit) {
  for (auto* error : {relativeL1, mape}) {
    EXPECT_NEAR(error(plane({1, -2, 5}), plane({2, -1, 4})), error(plane({8, -16, 40}), plane({16, -8, 32})),
                1e-12);
  }
}

}  // namespace
}  // namespace saccade::eval
