#include "stream/credit_queue.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

Packet makePacket(std::uint32_t sensor, std::uint64_t seq, std::size_t payload_bytes,
                  v1::Kind kind = v1::KIND_EVENTS) {
  v1::PacketHeader header;
  header.set_sensor(sensor);
  header.set_seq(seq);
  header.set_kind(kind);
  return sealPacket(std::move(header), std::string(payload_bytes, 'x'));
}

v1::PacketHeader popHeader(CreditQueue& queue) {
  v1::PacketHeader header;
  EXPECT_TRUE(queue.sendOldest([&](const WirePacket& packet) {
    EXPECT_EQ(packet.bytes(), packet.header.size() + packet.payload->size());
    return header.ParseFromString(packet.header);
  }));
  return header;
}

TEST(CreditQueue, HoldsTheProducerWhenFullAndLosesNothing) {
  CreditQueue queue(CreditQueue::Overflow::kHold, 2500, 1);
  std::uint64_t pushed = 0;
  for (; queue.hasRoom(); ++pushed) queue.push(makePacket(0, pushed, 1000));
  EXPECT_EQ(pushed, 3u);                      // the third overshoots
  queue.push(makePacket(0, pushed++, 1000));  // so may the rest of a frame
  for (std::uint64_t seq = 0; seq < pushed; ++seq) {
    const v1::PacketHeader header = popHeader(queue);
    EXPECT_EQ(header.seq(), seq);
    EXPECT_EQ(header.dropped_before(), 0u);
  }
  EXPECT_TRUE(queue.empty());
  EXPECT_TRUE(queue.hasRoom());
}

TEST(CreditQueue, KeepsWhatCannotBeSentAndLetsNothingInForIt) {
  CreditQueue queue(CreditQueue::Overflow::kHold, 1000, 1);
  const auto refuse = [](const WirePacket&) { return false; };
  EXPECT_FALSE(queue.sendOldest(refuse));
  queue.push(makePacket(0, 0, 1000));
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(queue.sendOldest(refuse));
    EXPECT_FALSE(queue.hasRoom());
  }
  EXPECT_EQ(popHeader(queue).seq(), 0u);
  EXPECT_TRUE(queue.hasRoom());
}

TEST(CreditQueue, DropsTheOldestAndTellsTheNextOfThatSensor) {
  CreditQueue queue(CreditQueue::Overflow::kDropOldest, 3500, 2);
  for (std::uint64_t seq = 0; seq < 5; ++seq) {
    queue.push(makePacket(0, seq, 1000));
    queue.push(makePacket(1, seq, 1000));
    EXPECT_TRUE(queue.hasRoom());
  }
  EXPECT_EQ(queue.droppedPackets(), 7u);  // three fit
  std::uint64_t next[2] = {};
  while (!queue.empty()) {
    const v1::PacketHeader header = popHeader(queue);
    EXPECT_EQ(header.seq(), next[header.sensor()] + header.dropped_before());
    next[header.sensor()] = header.seq() + 1;
  }
  EXPECT_EQ(next[0], 5u);
  EXPECT_EQ(next[1], 5u);
}

TEST(CreditQueue, NeverDropsEnd) {
  CreditQueue queue(CreditQueue::Overflow::kDropOldest, 2500, 2);
  queue.push(makePacket(0, 0, 0, v1::KIND_END));
  for (std::uint64_t seq = 0; seq < 10; ++seq) queue.push(makePacket(1, seq, 1000));
  EXPECT_EQ(popHeader(queue).kind(), v1::KIND_END);
  EXPECT_EQ(popHeader(queue).dropped_before(), 8u);
}

// A packet tells of the drops before it, and they must not be forgotten when it is dropped itself.
TEST(CreditQueue, DropsToldByADroppedPacketAreToldAgain) {
  CreditQueue queue(CreditQueue::Overflow::kDropOldest, 2500, 1);
  for (std::uint64_t seq = 0; seq < 4; ++seq) queue.push(makePacket(0, seq, 1000));
  const auto refuse = [](const WirePacket&) { return false; };
  EXPECT_FALSE(queue.sendOldest(refuse));
  queue.push(makePacket(0, 4, 1000));
  const v1::PacketHeader header = popHeader(queue);
  EXPECT_EQ(header.seq(), 3u);
  EXPECT_EQ(header.dropped_before(), 3u);
}

TEST(CreditQueue, ResumesWithWhatWasSentAndNotAcknowledged) {
  CreditQueue queue(CreditQueue::Overflow::kHold, 1 << 20, 1);
  for (std::uint64_t seq = 0; seq < 6; ++seq) queue.push(makePacket(0, seq, 100));
  for (int i = 0; i < 5; ++i) popHeader(queue);
  queue.acknowledge(0, 1);
  EXPECT_EQ(queue.resume({3}), "");
  for (std::uint64_t seq = 3; seq < 6; ++seq) EXPECT_EQ(popHeader(queue).seq(), seq);
  EXPECT_EQ(queue.resume({2}), "");  // 2 was kept all the while
  EXPECT_EQ(popHeader(queue).seq(), 2u);
}

// Drops between what was sent and what was not belong to the first that was not.
TEST(CreditQueue, ResumesWithTheDropsWhereTheyWere) {
  CreditQueue queue(CreditQueue::Overflow::kDropOldest, 2500, 1);
  for (std::uint64_t seq = 0; seq < 2; ++seq) queue.push(makePacket(0, seq, 1000));
  for (int i = 0; i < 2; ++i) popHeader(queue);
  for (std::uint64_t seq = 2; seq < 6; ++seq) queue.push(makePacket(0, seq, 1000));
  EXPECT_EQ(queue.resume({1}), "");
  for (const std::uint64_t seq : {1, 4, 5}) {
    const v1::PacketHeader header = popHeader(queue);
    EXPECT_EQ(header.seq(), seq);
    EXPECT_EQ(header.dropped_before(), seq == 4 ? 2u : 0u);
  }
}

// A client may have got what this end does not know to have arrived.
TEST(CreditQueue, ResumesEachSensorWhereItIs) {
  CreditQueue queue(CreditQueue::Overflow::kHold, 1 << 20, 2);
  for (std::uint64_t seq = 0; seq < 4; ++seq) {
    for (std::uint32_t sensor : {0u, 1u}) queue.push(makePacket(sensor, seq, 100));
  }
  for (int i = 0; i < 6; ++i) popHeader(queue);
  EXPECT_EQ(queue.resume({0, 0}), "");
  EXPECT_EQ(queue.resume({3, 1}), "");
  for (const auto& [sensor, seq] : {std::pair{1u, 1u}, {1u, 2u}, {0u, 3u}, {1u, 3u}}) {
    const v1::PacketHeader header = popHeader(queue);
    EXPECT_EQ(header.sensor(), sensor);
    EXPECT_EQ(header.seq(), seq);
  }
  EXPECT_TRUE(queue.empty());
}

TEST(CreditQueue, WhatIsAcknowledgedCannotBeHadAgain) {
  CreditQueue queue(CreditQueue::Overflow::kHold, 1 << 20, 1);
  queue.push(makePacket(0, 0, 100));
  popHeader(queue);
  queue.acknowledge(0, 0);
  EXPECT_NE(queue.resume({0}), "");
  EXPECT_EQ(queue.resume({1}), "");
}

TEST(CreditQueue, KeepsNoMoreOfWhatWasSentThanItsBound) {
  CreditQueue queue(CreditQueue::Overflow::kHold, 1250, 1);
  for (std::uint64_t seq = 0; seq < 10; ++seq) {
    queue.push(makePacket(0, seq, 1000));
    popHeader(queue);
  }
  EXPECT_NE(queue.resume({7}).find("8"), std::string::npos);  // names the first that is held
  EXPECT_EQ(queue.resume({8}), "");
  EXPECT_EQ(popHeader(queue).seq(), 8u);
}

// Else it would be a way to have more and more of it made and kept.
TEST(CreditQueue, WhatWasNeverSentCannotBePassedOver) {
  CreditQueue queue(CreditQueue::Overflow::kHold, 1 << 20, 2);
  for (std::uint64_t seq = 0; seq < 3; ++seq) {
    for (std::uint32_t sensor : {0u, 1u}) queue.push(makePacket(sensor, seq, 100));
  }
  popHeader(queue);
  EXPECT_NE(queue.resume({1, 1}).find("sensor 1 nothing"), std::string::npos);
  EXPECT_NE(queue.resume({2, 0}).find("seq 1 on"), std::string::npos);
  EXPECT_EQ(queue.resume({0, 0}), "");
  EXPECT_EQ(queue.resume({1, 0}), "");  // though it would have been sent again
  EXPECT_EQ(popHeader(queue).sensor(), 1u);
}

}  // namespace
}  // namespace saccade
