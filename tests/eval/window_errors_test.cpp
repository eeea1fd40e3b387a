#include "eval/metrics/window_errors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace saccade::eval {
namespace {

Event at(std::int64_t t_ns, int x, int p = 1) {
  return {.t_ns = t_ns, .x = static_cast<std::uint16_t>(x), .y = 3, .p = static_cast<std::uint8_t>(p)};
}

const Events kReference{at(100, 0), at(200, 0), at(900, 0), at(1100, 0), at(300, 1), at(400, 1, 0)};

TEST(WindowErrors, AreNoneOfTheReferenceItself) {
  const WindowErrors errors = windowErrors(kReference, kReference, 1000);
  EXPECT_EQ(errors.false_share, 0);
  EXPECT_EQ(errors.missed_share, 0);
  EXPECT_EQ(errors.time, 0);
}

// In any order: one event is missed in the first window and false in the second, one has another polarity.
TEST(WindowErrors, CountPerPixelPolarityAndWindow) {
  const Events events{at(1300, 0), at(1150, 0), at(250, 0), at(150, 0), at(320, 1), at(400, 1, 1)};
  const WindowErrors errors = windowErrors(events, kReference, 1000);
  EXPECT_DOUBLE_EQ(errors.false_share, 2 / 6.0);
  EXPECT_DOUBLE_EQ(errors.missed_share, 2 / 6.0);
  EXPECT_DOUBLE_EQ(errors.time, (50 + 50 + 50 + 20) / 4.0 / 1000);
}

TEST(WindowErrors, OfNothing) {
  EXPECT_EQ(windowErrors({}, kReference, 1000).missed_share, 1);
  EXPECT_TRUE(std::isnan(windowErrors({}, kReference, 1000).time));
  EXPECT_TRUE(std::isnan(windowErrors({}, {}, 1000).false_share));
}

}  // namespace
}  // namespace saccade::eval
