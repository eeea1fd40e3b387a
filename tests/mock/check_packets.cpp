#include <gtest/gtest.h>

#include "mock/mock_subscriber.h"

namespace saccade {
namespace {

void checkEvents(const v1::PacketHeader& header, const Events& events) {
  ASSERT_EQ(events.size(), header.count());
  std::int64_t t = header.t0_ns();
  for (const Event& event : events) {
    ASSERT_GE(event.t_ns, t);
    t = event.t_ns;
    ASSERT_LT(event.x, header.width());
    ASSERT_LT(event.y, header.height());
    ASSERT_LE(event.p, 1);
  }
  if (header.t0_ns() < header.t1_ns()) {
    ASSERT_TRUE(events.empty() || t < header.t1_ns());
  }
}

}  // namespace

Summary checkPackets(const Packets& packets, bool lossy, std::int64_t begin_ns) {
  Summary summary;
  std::uint64_t seq = 0, index = 0;
  std::int64_t t = begin_ns;
  for (const Received& packet : packets) {
    const v1::PacketHeader& header = packet.header;
    PacketContent content;
    EXPECT_EQ(decodePacket(header, packet.payload, content), "");
    EXPECT_EQ(header.seq(), seq + header.dropped_before());
    EXPECT_TRUE(lossy || header.dropped_before() == 0);
    if (header.dropped_before() == 0) {
      EXPECT_EQ(header.first_event_index(), index);
      EXPECT_EQ(header.t0_ns(), t);
    }
    EXPECT_GE(header.first_event_index(), index);
    EXPECT_GE(header.t0_ns(), t);
    checkEvents(header, content.events);
    summary.dropped += header.dropped_before();
    summary.packets += header.kind() == v1::KIND_EVENTS;
    summary.events += content.events.size();
    seq = header.seq() + 1;
    index = header.first_event_index() + header.count();
    t = header.t1_ns();
  }
  EXPECT_TRUE(!packets.empty() && packets.back().header.kind() == v1::KIND_END);
  summary.end_ns = t;
  return summary;
}

std::string comparableBytes(const Packets& packets) {
  std::string bytes;
  for (const Received& packet : packets) {
    v1::PacketHeader header = packet.header;
    header.clear_stream_id();
    header.clear_epoch();
    header.clear_lag_ms();
    bytes += header.SerializeAsString() + packet.payload;
  }
  return bytes;
}

}  // namespace saccade
