#include "app/feeds/turns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <vector>

#include "base/cancelled.h"

namespace saccade {
namespace {

TEST(Turns, AreOneAfterTheOtherForAKeyAndFreeForOthers) {
  Turns turns;
  auto first = turns.take("a", {});
  turns.take("b", {});  // does not wait
  std::atomic<bool> ended = false;
  std::jthread second([&] {
    const auto turn = turns.take("a", {});
    EXPECT_TRUE(ended);
  });
  ended = true;
  first.reset();
}

TEST(Turns, AreGivenToEachOfManyWhoWait) {
  Turns turns;
  int holders = 0, most = 0, taken = 0;  // guarded by the turn
  {
    std::vector<std::jthread> all;
    for (int i = 0; i < 20; ++i) {
      all.emplace_back([&] {
        const auto turn = turns.take("a", {});
        most = std::max(most, ++holders);
        ++taken, --holders;
      });
    }
  }
  EXPECT_EQ(most, 1);
  EXPECT_EQ(taken, 20);
}

TEST(Turns, AreNotWaitedForBeyondAStop) {
  Turns turns;
  const auto held = turns.take("a", {});
  std::stop_source stop;
  auto waiting = std::async(std::launch::async, [&] { turns.take("a", stop.get_token()); });
  stop.request_stop();
  EXPECT_THROW(waiting.get(), Cancelled);
}

}  // namespace
}  // namespace saccade
