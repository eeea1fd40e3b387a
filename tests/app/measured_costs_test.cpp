#include "app/feeds/measured_costs.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

using std::chrono::seconds;

const MeasuredCosts::Clock::time_point kBegin{seconds(1000)};

TEST(MeasuredCosts, CountForAMinute) {
  MeasuredCosts costs;
  EXPECT_FALSE(costs.find("a", kBegin));
  costs.add("a", {.feed = 3}, kBegin);
  EXPECT_FALSE(costs.find("b", kBegin));
  EXPECT_EQ(costs.find("a", kBegin + seconds(60))->feed, 3);
  EXPECT_FALSE(costs.find("a", kBegin + seconds(61)));
}

TEST(MeasuredCosts, AreBounded) {
  MeasuredCosts costs;
  for (std::size_t i = 0; i <= MeasuredCosts::kMost; ++i) costs.add(std::to_string(i), {}, kBegin);
  EXPECT_FALSE(costs.find("0", kBegin));
  EXPECT_TRUE(costs.find("1", kBegin));
  const std::string longest(MeasuredCosts::kMostKey + 1, 'x');
  costs.add(longest, {}, kBegin);
  EXPECT_FALSE(costs.find(longest, kBegin));
}

}  // namespace
}  // namespace saccade
