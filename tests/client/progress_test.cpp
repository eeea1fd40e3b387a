#include "client/terminal/progress.h"

#include <gtest/gtest.h>

namespace saccade::client {
namespace {

TEST(Progress, TimesAreShortToRead) {
  EXPECT_EQ(timeText(0.0625), "0.062 s");
  EXPECT_EQ(timeText(3.14), "3.1 s");
  EXPECT_EQ(timeText(60), "60 s");
  EXPECT_EQ(timeText(130.4), "2 min 10 s");
  EXPECT_EQ(timeText(3599.6), "1 h 0 min");
  EXPECT_EQ(timeText(7384), "2 h 3 min");
}

// stderr is not a terminal here, so the line comes only after 5 s.
TEST(Progress, ALineOfItsOwnComesAtOnce) {
  testing::internal::CaptureStderr();
  Progress progress(2);
  progress.update(1, 1, 1000);
  progress.tell("connection lost");
  progress.finish();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "connection lost\n");
}

}  // namespace
}  // namespace saccade::client
