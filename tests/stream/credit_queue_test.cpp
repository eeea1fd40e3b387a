#include "stream/credit_queue.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include "base/queue_bounds.h"
#include "mock/server_process.h"
#include "saccade/wire/packet_cutter.h"

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
  CreditQueue queue(CreditQueue::Overflow::kDropOldest, 4000, 2);
  for (std::uint64_t seq = 0; seq < 5; ++seq) {
    queue.push(makePacket(0, seq, 1000));
    queue.push(makePacket(1, seq, 1000));
    EXPECT_TRUE(queue.hasRoom());
    queue.makeRoom();
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

// Truth goes as events do.
TEST(CreditQueue, NeverDropsSnapshotsEndAndErrors) {
  constexpr v1::Kind kKept[] = {v1::KIND_SNAPSHOT, v1::KIND_END, v1::KIND_ERROR};
  CreditQueue queue(CreditQueue::Overflow::kDropOldest, 3300, 2);
  for (const v1::Kind kind : kKept) queue.push(makePacket(0, 0, 0, kind));
  for (std::uint64_t seq = 0; seq < 10; ++seq)
    queue.push(makePacket(1, seq, 1000, seq % 2 ? v1::KIND_TRUTH : v1::KIND_EVENTS));
  EXPECT_EQ(queue.makeRoom(), 8u);
  for (const v1::Kind kind : kKept) EXPECT_EQ(popHeader(queue).kind(), kind);
  EXPECT_EQ(popHeader(queue).dropped_before(), 8u);
}

// A client that keeps up gets all of a frame, however large it is.
TEST(CreditQueue, DropsOnlyWhatWasThereBeforeTheFrame) {
  constexpr std::uint32_t kChannels = 8;
  CreditQueue queue(CreditQueue::Overflow::kDropOldest, 2500, kChannels);
  const auto pushFrame = [&](std::uint64_t seq) {
    const std::uint64_t dropped = queue.makeRoom();
    for (std::uint32_t i = 0; i < kChannels; ++i) queue.push(makePacket(i, seq, 1000, v1::KIND_TRUTH));
    return dropped;
  };
  EXPECT_EQ(pushFrame(0), 0u);
  for (std::uint32_t i = 0; i < kChannels; ++i) EXPECT_EQ(popHeader(queue).dropped_before(), 0u);
  EXPECT_EQ(pushFrame(1), 0u);
  EXPECT_EQ(pushFrame(2), kChannels - 2u);  // two fit
  EXPECT_EQ(pushFrame(3), kChannels);
}

// A packet tells of the drops before it, and they must not be forgotten when it is dropped itself.
TEST(CreditQueue, DropsToldByADroppedPacketAreToldAgain) {
  CreditQueue queue(CreditQueue::Overflow::kDropOldest, 2500, 1);
  for (std::uint64_t seq = 0; seq < 4; ++seq) queue.push(makePacket(0, seq, 1000));
  queue.makeRoom();
  const auto refuse = [](const WirePacket&) { return false; };
  EXPECT_FALSE(queue.sendOldest(refuse));
  queue.push(makePacket(0, 4, 1000));
  queue.makeRoom();
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
  queue.makeRoom();
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

TEST(CreditQueue, AcknowledgedPacketsCannotBeResumed) {
  CreditQueue queue(CreditQueue::Overflow::kHold, 1 << 20, 1);
  queue.push(makePacket(0, 0, 100));
  popHeader(queue);
  queue.acknowledge(0, 0);
  EXPECT_NE(queue.resume({0}), "");
  EXPECT_EQ(queue.resume({1}), "");
}

TEST(CreditQueue, KeepsNoMoreOfWhatWasSentThanItsBound) {
  CreditQueue queue(CreditQueue::Overflow::kHold, 1000, 1);
  for (std::uint64_t seq = 0; seq < 10; ++seq) {
    queue.push(makePacket(0, seq, 1000));
    popHeader(queue);
  }
  EXPECT_NE(queue.resume({7}).find("8"), std::string::npos);  // names the first that is held
  EXPECT_EQ(queue.resume({8}), "");
  EXPECT_EQ(popHeader(queue).seq(), 8u);
}

// Of a sensor in a scene where next to nothing happens: a packet of `events` events every 5 ms.
class TinyPackets {
 public:
  explicit TinyPackets(std::size_t events) : events_(events) {}
  Packet next() {
    const std::int64_t t1_ns = t_ns_ + kPacketTimeNs;
    const Events events(events_, {t_ns_, 0, 0, 1});
    Packet packet = cutter_.cut(events, {t_ns_, t1_ns, frame_++, 0}).front();
    t_ns_ = t1_ns;
    return packet;
  }

 private:
  const std::size_t events_;
  PacketCutter cutter_{{.stream_id = "0123456789abcdef", .epoch = 1, .width = 1, .height = 1}};
  std::int64_t t_ns_ = 0;
  std::uint64_t frame_ = 0;
};

// PROTOCOL.md promises it to whoever gives no more credit than one bound, and acknowledges.
TEST(CreditQueue, KeepsOneBoundOfBytesThoughPacketsAreTiny) {
  constexpr std::uint64_t kBound = 1 << 20;
  for (const std::size_t events : {0, 1, 2, 3, 100}) {
    CreditQueue queue(CreditQueue::Overflow::kHold, kBound, 1);
    TinyPackets packets(events);
    for (std::uint64_t sent = 0; sent < kBound;) {
      queue.push(packets.next());
      queue.sendOldest([&](const WirePacket& packet) { return sent += packet.bytes(); });
    }
    EXPECT_EQ(queue.resume({0}), "") << events << " events";
  }
}

TEST(CreditQueue, CountsTheMemoryThatPacketsTake) {
  if (kSanitized) GTEST_SKIP() << "the sanitizer's heap is another";
  constexpr std::uint64_t kBound = 1 << 20, kMiB = 1 << 20;
  for (const std::size_t events : {0, 1, 2, 100, 2000}) {
    TinyPackets packets(events);
    malloc_trim(0);
    const std::size_t before = mallinfo2().uordblks;
    CreditQueue queue(CreditQueue::Overflow::kHold, kBound, 1);
    while (queue.hasRoom()) queue.push(packets.next());
    const double full = static_cast<double>(mallinfo2().uordblks - before) / kMiB;
    EXPECT_NEAR(full, 1, 0.1) << events << " events wait";
    for (int i = 0; i < 4; ++i) {
      while (queue.hasRoom()) queue.push(packets.next());
      while (queue.sendOldest([](const WirePacket&) { return true; })) {
      }
    }
    const double kept = static_cast<double>(mallinfo2().uordblks - before) / kMiB;
    EXPECT_NEAR(kept, kKeptBounds, 0.2) << events << " events are kept";
  }
}

// Each acknowledges nothing new. To look through all that is kept would take minutes.
TEST(CreditQueue, AFloodOfAcknowledgementsTakesNoTime) {
  CreditQueue queue(CreditQueue::Overflow::kHold, 16 << 20, 64);
  for (std::uint64_t seq = 0; seq < 1000; ++seq) {
    for (std::uint32_t sensor = 0; sensor < 64; ++sensor) queue.push(makePacket(sensor, seq, 0));
  }
  while (queue.sendOldest([](const WirePacket&) { return true; })) {
  }
  const auto began = std::chrono::steady_clock::now();
  for (int i = 0; i < 200'000; ++i) queue.acknowledge(0, 0);
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(2));
  EXPECT_EQ(queue.resume(std::vector<std::uint64_t>(64, 1)), "");
}

// Else it would be a way to have more and more of it made and kept.
TEST(CreditQueue, PacketsThatWereNeverSentCannotBeSkipped) {
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
