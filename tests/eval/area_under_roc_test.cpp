#include "eval/tasks/area_under_roc.h"

#include <gtest/gtest.h>

#include <cmath>

namespace saccade::eval {
namespace {

double area(std::vector<Scored> all) {
  return areaUnderRoc(all);
}

TEST(AreaUnderRoc, IsTheShareOfPairsInOrder) {
  EXPECT_DOUBLE_EQ(area({{3, true}, {1, false}, {4, true}, {2, false}}), 1);
  EXPECT_DOUBLE_EQ(area({{1, true}, {3, false}, {2, true}}), 0);
  // 4 above 1 and 3; 2 above 1 only.
  EXPECT_DOUBLE_EQ(area({{4, true}, {3, false}, {2, true}, {1, false}}), 3.0 / 4);
}

TEST(AreaUnderRoc, CountsTiesHalf) {
  EXPECT_DOUBLE_EQ(area({{1, true}, {1, false}, {1, false}}), 0.5);
  // 2 ties with one and is above the other; 3 is above both.
  EXPECT_DOUBLE_EQ(area({{2, true}, {2, false}, {1, false}, {3, true}}), 3.5 / 4);
}

TEST(AreaUnderRoc, NeedsBothClasses) {
  EXPECT_TRUE(std::isnan(area({{1, true}, {2, true}})));
  EXPECT_TRUE(std::isnan(area({{1, false}})));
  EXPECT_TRUE(std::isnan(area({})));
}

}  // namespace
}  // namespace saccade::eval
