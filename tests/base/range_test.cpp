#include "base/range.h"

#include <gtest/gtest.h>

#include <limits>

namespace saccade {
namespace {

TEST(RangeFault, IsEmptyInsideAndReadableOutside) {
  for (const double inside : {0.001, 0.5, 1.0}) EXPECT_EQ(rangeFault(inside, 0.001, 1), "");
  EXPECT_EQ(rangeFault(0, 0.001, 1), "0 is outside [0.001, 1]");
  EXPECT_EQ(rangeFault(1000001, 0, 1e6), "1000001 is outside [0, 1000000]");
  EXPECT_NE(rangeFault(std::numeric_limits<double>::quiet_NaN(), 0, 1), "");
  EXPECT_NE(rangeFault(std::numeric_limits<double>::infinity(), 0, 1e300), "");
}

}  // namespace
}  // namespace saccade
