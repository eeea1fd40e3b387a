#include "base/received_share.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

using namespace std::chrono_literals;

TEST(ReceivedShare, IsWhatBusyThreadsGotOfLate) {
  ReceivedShare share;
  const auto begin = ReceivedShare::Clock::now();
  EXPECT_EQ(share.value(), 1);
  share.add(0ms, 5ms, begin);
  EXPECT_GT(share.value(), 0.75);  // a short delay says little
  for (int i = 0; i < 100; ++i) share.add(30ms, 100ms, begin + i * 100ms);
  EXPECT_NEAR(share.value(), 0.3, 0.02);
  share.add(20ms, 20ms, begin + 60s);  // after an idle minute
  EXPECT_GT(share.value(), 0.99);
}

}  // namespace
}  // namespace saccade
