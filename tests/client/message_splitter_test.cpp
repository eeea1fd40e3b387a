#include "client/formats/common/message_splitter.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace saccade::client {
namespace {

constexpr std::int64_t kMs = 1'000'000;

class MessageSplitterTest : public testing::Test {
 protected:
  std::vector<Events> sent_;
  MessageSplitter splitter_{[this](const Events& events) { sent_.push_back(events); }};
};

Event at(std::int64_t t_ns) {
  return {t_ns, 1, 2, 1};
}

TEST_F(MessageSplitterTest, CutsAtMultiplesOfFiveMilliseconds) {
  splitter_.add({at(0), at(5 * kMs - 1000), at(5 * kMs), at(12 * kMs)}, 13 * kMs);
  splitter_.add({at(14 * kMs)}, 14 * kMs);
  EXPECT_EQ(sent_, (std::vector<Events>{{at(0), at(5 * kMs - 1000)}, {at(5 * kMs)}}));
  splitter_.flush();
  EXPECT_EQ(sent_.back(), (Events{at(12 * kMs), at(14 * kMs)}));
}

TEST_F(MessageSplitterTest, SendsAMessageAsSoonAsItIsComplete) {
  splitter_.add({at(3 * kMs)}, 5 * kMs - 1000);
  EXPECT_TRUE(sent_.empty());
  splitter_.add({}, 5 * kMs);
  EXPECT_EQ(sent_, (std::vector<Events>{{at(3 * kMs)}}));
  splitter_.flush();
  EXPECT_EQ(sent_.size(), 1u);
}

TEST_F(MessageSplitterTest, TimesBelowZeroHaveTheSameIntervals) {
  splitter_.add({at(-6 * kMs), at(-5 * kMs), at(-kMs), at(0)}, kMs);
  EXPECT_EQ(sent_, (std::vector<Events>{{at(-6 * kMs)}, {at(-5 * kMs), at(-kMs)}}));
}

TEST_F(MessageSplitterTest, AMessageThatCouldNotBeSentIsNotSentAgain) {
  int calls = 0;
  MessageSplitter splitter([&](const Events&) { ++calls, throw std::runtime_error("full"); });
  EXPECT_THROW(splitter.add({at(0), at(6 * kMs)}, 6 * kMs), std::runtime_error);
  splitter.flush();
  EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace saccade::client
