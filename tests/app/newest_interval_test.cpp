#include "app/feeds/newest_interval.h"

#include <gtest/gtest.h>

#include "app/interval_of.h"
#include "base/counting_new.h"

namespace saccade {
namespace {

TEST(NewestInterval, IsNothingBeforeTheFirst) {
  EXPECT_EQ(NewestInterval().copy(), nullptr);
}

TEST(NewestInterval, IsACopyThatLaterOnesLeaveAlone) {
  NewestInterval newest;
  const auto first = intervalOf(1, 1, 0.5f), second = intervalOf(2, 1, 0.25f);
  newest.set(*first, 1);
  const auto copy = newest.copy();
  newest.set(*second, 2);
  first->I_now.fill(7);
  EXPECT_EQ(copy->frame, 1u);
  EXPECT_EQ(copy->I_now.at(3, 2), std::exp(0.5f));
  EXPECT_EQ(newest.copy()->frame, 2u);
}

TEST(NewestInterval, IsNotCopiedUnlessSomebodyAsks) {
  NewestInterval newest;
  const auto change = intervalOf(1, 1, 0.5f);
  const int before = test::allocations();
  newest.set(*change, 1);
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace saccade
