#include "saccade/wire/packet_cutter.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

constexpr std::int64_t kT0 = 5'000'000, kT1 = 10'000'000;  // one packet's time

PacketCutter makeCutter() {
  return PacketCutter({"s1", 9, 3, 346, 260, &kCodecNone});
}

void append(Events& events, std::int64_t t_ns, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = events.size();
    events.push_back(
        {t_ns, static_cast<std::uint16_t>(at % 346), static_cast<std::uint16_t>(at / 346 % 260), 1});
  }
}

// The rules that hold for the packets of any interval. Returns the sizes.
std::vector<std::uint32_t> checkTiling(const std::vector<Packet>& packets, const Events& events) {
  std::vector<std::uint32_t> sizes;
  Events all;
  std::int64_t t = kT0;
  for (const Packet& packet : packets) {
    PacketContent part;
    EXPECT_EQ(decodePacket(packet.header, *packet.payload, part), "");
    EXPECT_EQ(packet.header.t0_ns(), t);
    EXPECT_EQ(packet.header.first_event_index(), all.size());
    EXPECT_EQ(packet.header.seq(), sizes.size());
    EXPECT_EQ(packet.header.frame(), 1u);
    t = packet.header.t1_ns();
    sizes.push_back(packet.header.count());
    all.insert(all.end(), part.events.begin(), part.events.end());
  }
  EXPECT_EQ(t, kT1);
  EXPECT_EQ(all, events);
  return sizes;
}

std::vector<std::uint32_t> cutSizes(const Events& events) {
  return checkTiling(makeCutter().cut(events, {kT0, kT1, 1, 0}), events);
}

using Sizes = std::vector<std::uint32_t>;

TEST(PacketCutter, EmptyIntervalIsOneEmptyPacket) {
  EXPECT_EQ(cutSizes({}), Sizes{0});
}

TEST(PacketCutter, UpToTheMaximumIsOnePacket) {
  Events events;
  append(events, kT0, 10);
  append(events, kT1 - 1000, kMaxPacketEvents - 10);
  EXPECT_EQ(cutSizes(events), Sizes{kMaxPacketEvents});
}

TEST(PacketCutter, CutsBetweenTwoTimes) {
  Events events;
  append(events, kT0 + 1000, kMaxPacketEvents - 5);
  append(events, kT0 + 2000, 10);  // would straddle the cut
  EXPECT_EQ(cutSizes(events), (Sizes{kMaxPacketEvents - 5, 10}));
  EXPECT_EQ(makeCutter().cut(events, {kT0, kT1, 1, 0})[0].header.t1_ns(), kT0 + 2000);
}

TEST(PacketCutter, OneTimeInManyPackets) {
  Events events;
  append(events, kT0 + 5000, 2 * kMaxPacketEvents + 7);
  append(events, kT0 + 6000, 3);
  EXPECT_EQ(cutSizes(events), (Sizes{0, kMaxPacketEvents, kMaxPacketEvents, 10}));
  const auto packets = makeCutter().cut(events, {kT0, kT1, 1, 0});
  EXPECT_EQ(packets[1].header.t0_ns(), kT0 + 5000);
  EXPECT_EQ(packets[1].header.t1_ns(), kT0 + 5000);
}

TEST(PacketCutter, OneTimeThatFillsPacketsExactly) {
  Events events;
  append(events, kT0, 2 * kMaxPacketEvents);
  EXPECT_EQ(cutSizes(events), (Sizes{kMaxPacketEvents, kMaxPacketEvents}));
  append(events, kT1 - 1000, 1);
  EXPECT_EQ(cutSizes(events), (Sizes{kMaxPacketEvents, kMaxPacketEvents, 1}));
}

using Span = std::pair<std::int64_t, std::int64_t>;

std::vector<Span> spansOf(const std::vector<Packet>& packets) {
  std::vector<Span> spans;
  for (const Packet& packet : packets) spans.emplace_back(packet.header.t0_ns(), packet.header.t1_ns());
  return spans;
}

TEST(PacketCutter, ALongFrameFillsAPacketEvery5Milliseconds) {
  Events events;
  append(events, 12'000'000, 3);
  const auto packets = makeCutter().cut(events, {3'000'000, 15'000'000, 1, 8});
  EXPECT_EQ(spansOf(packets),
            (std::vector<Span>{{3'000'000, 5'000'000}, {5'000'000, 10'000'000}, {10'000'000, 15'000'000}}));
  EXPECT_EQ(packets[2].header.count(), 3u);
  EXPECT_EQ(packets[0].header.suppressed(), 8u);
  EXPECT_EQ(packets[1].header.suppressed() + packets[2].header.suppressed(), 0u);
}

TEST(PacketCutter, ShortFramesShareAPacket) {
  PacketCutter cutter = makeCutter();
  Events first, last;
  append(first, 1'000'000, 4);
  append(last, 4'999'000, 2);
  EXPECT_TRUE(cutter.cut(first, {0, 2'000'000, 0, 1}).empty());
  EXPECT_TRUE(cutter.cut({}, {2'000'000, 4'000'000, 1, 2, 0, 1}).empty());
  const auto packets = cutter.cut(last, {4'000'000, 6'000'000, 2, 4, 0, 3});
  ASSERT_EQ(spansOf(packets), (std::vector<Span>{{0, 5'000'000}}));
  EXPECT_EQ(packets[0].header.count(), 6u);
  EXPECT_EQ(packets[0].header.frame(), 0u);
  EXPECT_EQ(packets[0].header.suppressed(), 7u);  // of all frames that begin in it
  EXPECT_EQ(packets[0].header.lost_in_readout(), 4u);
  const auto next = cutter.cut({}, {6'000'000, 12'000'000, 3, 0});
  ASSERT_EQ(spansOf(next), (std::vector<Span>{{5'000'000, 10'000'000}}));
  EXPECT_EQ(next[0].header.frame(), 2u);  // which holds 5 ms
}

TEST(PacketCutter, EnoughEventsDoNotWait) {
  PacketCutter cutter = makeCutter();
  Events few, many;
  append(few, 0, kEnoughEvents - 1);
  append(many, 1'500'000, 1);
  EXPECT_TRUE(cutter.cut(few, {0, 1'000'000, 0, 0}).empty());
  const auto packets = cutter.cut(many, {1'000'000, 2'000'000, 1, 0});
  ASSERT_EQ(spansOf(packets), (std::vector<Span>{{0, 2'000'000}}));
  EXPECT_EQ(packets[0].header.count(), kEnoughEvents);
}

TEST(PacketCutter, CountsAcrossIntervalsAndEnds) {
  PacketCutter cutter = makeCutter();
  Events events;
  append(events, 0, 4);
  cutter.cut(events, {0, 5'000'000, 0, 0});
  EXPECT_TRUE(cutter.cut({}, {5'000'000, 7'000'000, 1, 6}).empty());
  const auto last = cutter.end(7'000'000, 2, v1::END_REASON_CLOSED);
  ASSERT_EQ(last.size(), 2u);
  EXPECT_EQ(spansOf(last), (std::vector<Span>{{5'000'000, 7'000'000}, {7'000'000, 7'000'000}}));
  EXPECT_EQ(last[0].header.suppressed(), 6u);
  for (std::uint64_t i : {0u, 1u}) {
    EXPECT_EQ(last[i].header.seq(), i + 1);
    EXPECT_EQ(last[i].header.first_event_index(), 4u);
    EXPECT_EQ(last[i].header.frame(), i + 1);
    EXPECT_EQ(checkPacket(last[i].header, *last[i].payload), "");
  }
  EXPECT_EQ(last[1].header.kind(), v1::KIND_END);
  EXPECT_EQ(last[1].header.end_reason(), v1::END_REASON_CLOSED);
}

TEST(PacketCutter, NothingLeftIsEndAlone) {
  PacketCutter cutter = makeCutter();
  cutter.cut({}, {0, 5'000'000, 0, 0});
  EXPECT_EQ(cutter.end(5'000'000, 1, v1::END_REASON_FINISHED).size(), 1u);
}

TEST(PacketCutter, ASnapshotComesFirstAndCountsAsAPacket) {
  PacketCutter cutter = makeCutter();
  const std::string planes(std::size_t{346} * 260 * kPlanesBytesPerPixel, 1);
  const Packet snapshot = cutter.snapshot(kT0, 7, planes);
  PacketContent content;
  EXPECT_EQ(decodePacket(snapshot.header, *snapshot.payload, content), "");
  EXPECT_EQ(encodePlanes(content.pixels), planes);
  EXPECT_EQ(spansOf({snapshot}), (std::vector<Span>{{kT0, kT0}}));
  EXPECT_EQ(cutter.cut({}, {kT0, kT1, 7, 0})[0].header.seq(), 1u);
}

TEST(PacketCutter, CodecOfTheStream) {
  PacketCutter cutter({.stream_id = "s1", .width = 346, .height = 260, .codec = &kCodecZstd});
  Events events;
  append(events, kT0, 1000);
  const Packet packet = cutter.cut(events, {kT0, kT1, 1, 0}).at(0);
  EXPECT_LT(packet.payload->size(), 9 * events.size());
  PacketContent content;
  EXPECT_EQ(decodePacket(packet.header, *packet.payload, content), "");
  EXPECT_EQ(content.events, events);
}

TEST(PacketCutter, EveryPacketSaysWhereItComesFrom) {
  const Packet packet = makeCutter().cut({}, {0, kPacketTimeNs, 0, 0}).at(0);
  EXPECT_EQ(packet.header.stream_id(), "s1");
  EXPECT_EQ(packet.header.epoch(), 9u);
  EXPECT_EQ(packet.header.sensor(), 3u);
  EXPECT_EQ(packet.header.width(), 346u);
  EXPECT_EQ(packet.header.height(), 260u);
}

}  // namespace
}  // namespace saccade
