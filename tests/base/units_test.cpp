#include "base/units.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

// Every frame time is the exact one rounded to whole microseconds. This holds where the period is no whole
// number of them, and late in a long stream.
TEST(FrameTime, IsTheExactTimeRoundedToMicroseconds) {
  for (const std::int64_t rate : {1, 24, 30, 200, 500, 960, 3000}) {
    for (const FrameIndex t : {0ull, 1ull, 2ull, 7ull, 1000ull, 123'456'789ull}) {
      const std::int64_t exact_us = (static_cast<std::int64_t>(t) * 2'000'000 + rate) / (2 * rate);
      EXPECT_EQ(frameTime(t, static_cast<double>(rate)).count(), exact_us * 1000) << t << " at " << rate;
    }
  }
}

TEST(FrameTime, NeverStandsStillUpToTenKilohertz) {
  for (FrameIndex t = 0; t < 20'000; ++t) {
    ASSERT_LT(frameTime(t, 9999.9), frameTime(t + 1, 9999.9)) << t;
  }
}

TEST(Seconds, IsNanosecondsOverABillion) {
  EXPECT_DOUBLE_EQ(seconds(TimeNs(1'234'567'890)), 1.23456789);
}

}  // namespace
}  // namespace saccade
