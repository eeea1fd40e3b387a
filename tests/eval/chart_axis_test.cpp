#include "eval/pictures/chart_axis.h"

#include <gtest/gtest.h>

#include <cmath>

namespace saccade::eval {
namespace {

using Values = std::vector<double>;

ChartAxis axis(Scale scale, const Values& values) {
  ChartAxis axis(scale, 0, 100);
  for (const double v : values) axis.include(v);
  return axis;
}

TEST(LinearAxis, HasRoundTicksAndAMargin) {
  const ChartAxis a = axis(Scale::kLinear, {0, 1});
  const Values ticks = a.ticks();
  ASSERT_EQ(ticks.size(), 6u);
  for (std::size_t i = 0; i < ticks.size(); ++i) EXPECT_NEAR(ticks[i], 0.2 * static_cast<double>(i), 1e-12);
  EXPECT_NEAR(a(0.5), 50, 1e-9);
  EXPECT_GT(a(0), 0);
  EXPECT_LT(a(1), 100);
  EXPECT_NEAR(a(0.25) - a(0), a(0.75) - a(0.5), 1e-9);
}

TEST(LinearAxis, GoesBelowZero) {
  EXPECT_EQ(axis(Scale::kLinear, {-0.9, 0.9}).ticks(), (Values{-0.5, 0, 0.5}));
}

TEST(LinearAxis, LivesWithASingleValue) {
  EXPECT_NEAR(axis(Scale::kLinear, {7, 7})(7), 50, 1e-9);
}

TEST(LogAxis, HasStepsOfOneTwoFive) {
  const ChartAxis a = axis(Scale::kLog, {0.1, 10});
  const Values ticks = a.ticks(), expected{0.1, 0.2, 0.5, 1, 2, 5, 10};
  ASSERT_EQ(ticks.size(), expected.size());
  for (std::size_t i = 0; i < ticks.size(); ++i) EXPECT_DOUBLE_EQ(ticks[i], expected[i]);
  EXPECT_NEAR(a(1), 50, 1e-9);
}

TEST(LogAxis, HasFinerStepsWhereTwoWouldBeAll) {
  const Values ticks = axis(Scale::kLog, {0.05, 0.09}).ticks(), expected{0.05, 0.06, 0.07, 0.08, 0.09, 0.1};
  ASSERT_EQ(ticks.size(), expected.size());
  for (std::size_t i = 0; i < ticks.size(); ++i) EXPECT_DOUBLE_EQ(ticks[i], expected[i]);
}

TEST(LogAxis, HasNoPlaceForZero) {
  EXPECT_DEATH(axis(Scale::kLog, {0}), "v > 0");
  EXPECT_DEATH(axis(Scale::kLinear, {std::nan("")}), "isfinite");
}

TEST(LogAxis, HasWholeDecadesWhereThereAreMany) {
  const Values ticks = axis(Scale::kLog, {1e-9, 1}).ticks();
  ASSERT_EQ(ticks.size(), 10u);
  for (std::size_t i = 1; i < ticks.size(); ++i) EXPECT_NEAR(ticks[i] / ticks[i - 1], 10, 1e-9);
}

}  // namespace
}  // namespace saccade::eval
