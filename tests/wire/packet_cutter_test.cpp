#include "wire/packet_cutter.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

constexpr std::int64_t kT0 = 2'000'000, kT1 = 4'000'000;

PacketCutter makeCutter() {
  return PacketCutter({"s1", 9, 3, 346, 260});
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
    Events part;
    EXPECT_EQ(decodePacket(packet.header, *packet.payload, part), "");
    EXPECT_EQ(packet.header.t0_ns(), t);
    EXPECT_EQ(packet.header.first_event_index(), all.size());
    EXPECT_EQ(packet.header.seq(), sizes.size());
    EXPECT_EQ(packet.header.frame(), 1u);
    t = packet.header.t1_ns();
    sizes.push_back(packet.header.count());
    all.insert(all.end(), part.begin(), part.end());
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

TEST(PacketCutter, CountsAcrossIntervalsAndEnds) {
  PacketCutter cutter = makeCutter();
  Events events;
  append(events, 0, 4);
  cutter.cut(events, {0, 2000, 0, 0});
  const Packet second = cutter.cut({}, {2000, 4000, 1, 6}).at(0);
  const Packet end = cutter.end(4000, 2);
  EXPECT_EQ(second.header.seq(), 1u);
  EXPECT_EQ(second.header.first_event_index(), 4u);
  EXPECT_EQ(second.header.suppressed(), 6u);
  EXPECT_EQ(end.header.kind(), v1::KIND_END);
  EXPECT_EQ(end.header.seq(), 2u);
  EXPECT_EQ(end.header.first_event_index(), 4u);
  EXPECT_EQ(end.header.t0_ns(), 4000);
  EXPECT_EQ(end.header.t1_ns(), 4000);
  EXPECT_EQ(end.header.frame(), 2u);
  EXPECT_EQ(checkPacket(end.header, *end.payload), "");
}

TEST(PacketCutter, EveryPacketSaysWhereItComesFrom) {
  const Packet packet = makeCutter().cut({}, {0, 1000, 0, 0}).at(0);
  EXPECT_EQ(packet.header.stream_id(), "s1");
  EXPECT_EQ(packet.header.epoch(), 9u);
  EXPECT_EQ(packet.header.sensor(), 3u);
  EXPECT_EQ(packet.header.width(), 346u);
  EXPECT_EQ(packet.header.height(), 260u);
}

}  // namespace
}  // namespace saccade
