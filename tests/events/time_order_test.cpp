#include "events/time_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace saccade {
namespace {

// Against std::stable_sort, for intervals that need one, two and three passes.
TEST(TimeOrder, SortsStably) {
  std::mt19937 random(3);
  for (const std::int64_t ticks : {1, 2, 2000, 2048, 2049, 100'000, 10'000'000}) {
    const Interval interval{TimeNs(7'000), TimeNs(7'000) + ticks * kEventTimeUnit, 1};
    std::uniform_int_distribution<std::int64_t> tick(0, ticks - 1);
    Events events;
    for (std::uint16_t i = 0; i < 5000; ++i) events.push_back({7'000 + tick(random) * 1000, i, 0, 1});
    Events expected = events;
    std::stable_sort(expected.begin(), expected.end(), [](auto& a, auto& b) { return a.t_ns < b.t_ns; });
    TimeOrder().sort(events, interval);
    EXPECT_EQ(events, expected) << ticks;
  }
}

TEST(TimeOrder, TakesNoEventsToo) {
  Events events;
  TimeOrder().sort(events, {TimeNs(0), TimeNs(1000), 1});
  EXPECT_TRUE(events.empty());
}

}  // namespace
}  // namespace saccade
