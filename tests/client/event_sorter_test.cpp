#include "client/formats/common/event_sorter.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "random_events.h"

namespace saccade::client {
namespace {

std::string faultOf(EventSorter& sorter, Events events) {
  try {
    sorter.push(events);
  } catch (const FileFault& fault) {
    return fault.what();
  }
  return "none";
}

TEST(EventSorter, PutsLateEventsInOrderWhateverTheBatches) {
  Events expected = randomEvents(10'000, 640, 480);
  for (std::size_t i = 0; i < expected.size(); ++i) expected[i].t_ns = static_cast<std::int64_t>(i) * 1000;
  Events mixed = expected;
  for (std::size_t i = 0; i + 5 <= mixed.size(); i += 5)
    std::reverse(mixed.begin() + i, mixed.begin() + i + 5);
  for (const std::size_t size : {1, 3, 1000}) {
    EventSorter sorter("a.csv", 4);
    Events all, batch;
    for (std::size_t i = 0; i < mixed.size(); i += size) {
      batch.assign(mixed.begin() + i, mixed.begin() + std::min(i + size, mixed.size()));
      sorter.push(batch);
      all.insert(all.end(), batch.begin(), batch.end());
    }
    sorter.finish(batch);
    EXPECT_LE(batch.size(), size + 5);  // it holds no more than the window
    all.insert(all.end(), batch.begin(), batch.end());
    EXPECT_EQ(all, expected) << size;
    EXPECT_EQ(sorter.late(), 8000u);
    EXPECT_EQ(sorter.longestNs(), 4000);
  }
}

TEST(EventSorter, EventsOfOneTimeKeepTheirOrder) {
  EventSorter sorter("a.csv", 10);
  Events events{{5000, 1, 0, 1}, {6000, 2, 0, 1}, {5000, 3, 0, 1}, {5000, 4, 0, 0}};
  sorter.push(events);
  EXPECT_TRUE(events.empty());
  sorter.finish(events);
  EXPECT_EQ(events, (Events{{5000, 1, 0, 1}, {5000, 3, 0, 1}, {5000, 4, 0, 0}, {6000, 2, 0, 1}}));
}

TEST(EventSorter, AnEventBeyondTheWindowIsRefused) {
  EventSorter sorter("a.csv", 2);
  EXPECT_EQ(faultOf(sorter, {{5000, 1, 0, 1}, {3000, 2, 0, 1}}), "none");
  EXPECT_EQ(faultOf(sorter, {{2000, 1, 0, 1}}),
            "a.csv: event 3 is 3 us earlier than one before, beyond the window of --sort 2");
}

TEST(EventSorter, HoldsSoManyEventsAtMost) {
  EventSorter sorter("a.csv", 1'000'000);
  const Events batch(1 << 20, Event{5000, 1, 0, 1});
  for (int i = 0; i < 4; ++i) EXPECT_EQ(faultOf(sorter, batch), "none");
  EXPECT_NE(faultOf(sorter, {{5000, 1, 0, 1}}).find("more than 4194304 events in a window of --sort 1000000"),
            std::string::npos);
}

}  // namespace
}  // namespace saccade::client
