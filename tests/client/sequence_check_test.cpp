#include "client/sequence_check.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

v1::PacketHeader headerOf(std::uint32_t sensor, std::uint64_t seq, std::uint64_t first, std::uint32_t count,
                          std::int64_t t0_ns, std::int64_t t1_ns) {
  v1::PacketHeader header;
  header.set_kind(v1::KIND_EVENTS);
  header.set_sensor(sensor);
  header.set_seq(seq);
  header.set_first_event_index(first);
  header.set_count(count);
  header.set_t0_ns(t0_ns);
  header.set_t1_ns(t1_ns);
  return header;
}

TEST(SequenceCheck, SensorsAreFollowedApart) {
  SequenceCheck check;
  EXPECT_EQ(check.add(headerOf(0, 0, 0, 5, 0, 1000)), "");
  EXPECT_EQ(check.add(headerOf(1, 0, 0, 2, 0, 1000)), "");
  EXPECT_EQ(check.add(headerOf(0, 1, 5, 0, 1000, 2000)), "");
  EXPECT_EQ(check.add(headerOf(1, 1, 2, 0, 1000, 2000)), "");
  EXPECT_EQ(check.losses().gaps, 0u);
}

TEST(SequenceCheck, AStreamMayBeginAtAnyTime) {
  SequenceCheck check;
  EXPECT_EQ(check.add(headerOf(0, 0, 0, 5, 8000, 9000)), "");
  EXPECT_EQ(check.add(headerOf(1, 0, 0, 2, 8000, 9000)), "");
  EXPECT_EQ(check.add(headerOf(0, 1, 5, 1, 9000, 9500)), "");
  EXPECT_EQ(check.losses().gaps, 0u);
  EXPECT_NE(check.add(headerOf(1, 1, 2, 1, 9500, 9900)), "");  // from then on without holes
}

TEST(SequenceCheck, AGapIsCountedOnce) {
  SequenceCheck check;
  EXPECT_EQ(check.add(headerOf(0, 3, 70, 5, 4000, 5000)), "");  // seq 0, 1 and 2 are missing
  EXPECT_EQ(check.add(headerOf(0, 4, 75, 5, 5000, 6000)), "");
  EXPECT_EQ(check.losses().gaps, 1u);
  EXPECT_EQ(check.losses().packets, 3u);
  EXPECT_EQ(check.losses().events, 70u);
}

TEST(SequenceCheck, HeartbeatsTakeNoSeq) {
  SequenceCheck check;
  auto heartbeat = headerOf(0, 0, 0, 0, 0, 0);
  heartbeat.set_kind(v1::KIND_HEARTBEAT);
  EXPECT_EQ(check.add(headerOf(0, 0, 0, 0, 0, 1000)), "");
  EXPECT_EQ(check.add(heartbeat), "");
  EXPECT_EQ(check.add(headerOf(0, 1, 0, 0, 1000, 2000)), "");
  EXPECT_EQ(check.losses().gaps, 0u);
}

TEST(SequenceCheck, WhatDoesNotFollowIsAFault) {
  const auto second = [](const v1::PacketHeader& header) {
    SequenceCheck check;
    EXPECT_EQ(check.add(headerOf(0, 0, 0, 5, 0, 1000)), "");
    return check.add(header);
  };
  EXPECT_NE(second(headerOf(0, 0, 0, 5, 0, 1000)), "");     // again
  EXPECT_NE(second(headerOf(0, 1, 5, 5, 2000, 3000)), "");  // a hole in time
  EXPECT_NE(second(headerOf(0, 1, 6, 5, 1000, 2000)), "");  // a hole in the events
  EXPECT_NE(second(headerOf(0, 2, 4, 5, 2000, 3000)), "");  // events run backwards
}

}  // namespace
}  // namespace saccade
