#include "tables/time_model.h"

#include <gtest/gtest.h>

#include <limits>

namespace saccade {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

// 2 ms of a frame are fixed, and 8 ms go with its pixels. Late frames take 0.6 times as long.
constexpr MeasuredTime kTime{10, 2 + 8 / 4.0, 0.6 * (2 + 8 / 4.0)};

TEST(TimeModel, IsExactWhereItWasMeasured) {
  EXPECT_DOUBLE_EQ(timeAt(kTime, 1, 1), 10);
  EXPECT_DOUBLE_EQ(timeAt(kTime, 0.25, 1), 4);
}

TEST(TimeModel, HasAFixedPart) {
  EXPECT_DOUBLE_EQ(timeAt(kTime, 4, 1), 2 + 4 * 8);
  EXPECT_DOUBLE_EQ(timeAt(kTime, 1.0 / 16, 1), 2 + 8 / 16.0);
}

TEST(TimeModel, FallsToThatOfLateFrames) {
  EXPECT_DOUBLE_EQ(timeAt(kTime, 1, kEndless), 6);
  EXPECT_DOUBLE_EQ(timeAt(kTime, 4, kEndless), 0.6 * 34);
  EXPECT_DOUBLE_EQ(timeAt(kTime, 1, 2), (10 + 6) / 2.0);  // as many frames of the one kind as of the other
  EXPECT_DOUBLE_EQ(timeAt(kTime, 1, 0.1), 10);
}

TEST(TimeModel, GrowsWithThePixelsWhereNoMoreIsKnown) {
  EXPECT_DOUBLE_EQ(timeAt({10}, 3, 50), 30);
}

// By noise a small picture may take less than its share of the time, or more than the large one.
TEST(TimeModel, NoPartIsBelowZero) {
  EXPECT_DOUBLE_EQ(timeAt({10, 2}, 0.5, 1), 5);
  EXPECT_DOUBLE_EQ(timeAt({10, 11}, 16, 1), 10);
  EXPECT_DOUBLE_EQ(timeAt({0, 0, 0}, 16, 5), 0);
}

}  // namespace
}  // namespace saccade
