#include "app/sequence/sensor_channel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/interval_of.h"

namespace saccade {
namespace {

constexpr float kIntensity = 1;

// Three frame intervals of kPacketTimeNs, each of which fills one packet.
class SensorPackets : public testing::Test {
 protected:
  const SensorConfig config_{.reconstruction = "direct", .seed = 7};
  const PacketSource source_{.stream_id = "s", .width = kWidth, .height = kHeight};

  // Events and packets of the intervals `first` to 3.
  std::vector<Packet> packetsOf(SensorChannel& channel, FrameIndex first = 1) const {
    std::vector<Packet> all;
    for (FrameIndex frame = first; frame <= 3; ++frame) {
      channel.process(StillView(intervalOf(frame, kIntensity, 0.5f)).interval(), false);
      for (Packet& packet : channel.takePackets()) all.push_back(std::move(packet));
    }
    return all;
  }
  static PacketContent contentOf(const Packet& packet) {
    PacketContent content;
    EXPECT_EQ(decodePacket(packet.header, *packet.payload, content), "");
    return content;
  }
};

TEST_F(SensorPackets, PutsTheEventsOfItsSensorIntoPackets) {
  SensorChannel channel(config_, source_, 0);
  const std::vector<Packet> packets = packetsOf(channel);
  ASSERT_EQ(packets.size(), 3u);
  Sensor sensor(config_, kWidth, kHeight);
  std::uint64_t events = 0;
  for (FrameIndex frame = 1; frame <= 3; ++frame) {
    SensorOutput expected;
    sensor.generate(*intervalOf(frame, kIntensity, 0.5f), expected);
    const Packet& packet = packets[frame - 1];
    EXPECT_EQ(contentOf(packet).events, expected.events);
    EXPECT_EQ(packet.header.first_event_index(), events);
    EXPECT_EQ(packet.header.t0_ns(), static_cast<std::int64_t>(frame - 1) * kPacketTimeNs);
    EXPECT_EQ(packet.header.t1_ns(), static_cast<std::int64_t>(frame) * kPacketTimeNs);
    events += expected.events.size();
  }
  EXPECT_EQ(channel.items(), events);
  EXPECT_GE(events, 3u * kWidth * kHeight * 2);  // a change of 0.5 holds two thresholds of 0.2
  EXPECT_TRUE(channel.takePackets().empty());
}

TEST_F(SensorPackets, ThatJoinsLateBeginsWithTheStateOfItsPixels) {
  SensorChannel channel(config_, source_, 0);
  const std::vector<Packet> packets = packetsOf(channel, 2);
  ASSERT_EQ(packets.size(), 3u);
  EXPECT_EQ(packets[0].header.kind(), v1::KIND_SNAPSHOT);
  EXPECT_EQ(packets[0].header.t0_ns(), kPacketTimeNs);
  for (const float brightness : contentOf(packets[0]).pixels.brightness)
    EXPECT_NEAR(brightness, std::log(kIntensity + config_.bias), 1e-5);
  EXPECT_EQ(packets[1].header.kind(), v1::KIND_EVENTS);
  EXPECT_EQ(packets[1].header.t0_ns(), kPacketTimeNs);
}

TEST_F(SensorPackets, GoesOnFromAnEvent) {
  SensorChannel whole(config_, source_, 0);
  const std::vector<Packet> all = packetsOf(whole);
  const std::uint64_t second = all[1].header.first_event_index(), third = all[2].header.first_event_index();
  const struct {
    std::uint64_t from_event;
    std::size_t packets;
  } cases[] = {{1, 3}, {second - 1, 3}, {second, 2}, {second + 1, 2}, {third, 1}, {third + (1u << 20), 0}};
  for (const auto& [from_event, packets] : cases) {
    SensorChannel channel(config_, source_, from_event);
    EXPECT_TRUE(channel.catchingUp());
    const std::vector<Packet> given = packetsOf(channel);
    ASSERT_EQ(given.size(), packets) << from_event;
    EXPECT_EQ(channel.catchingUp(), packets == 0);
    for (std::size_t i = 0; i < packets; ++i) {
      const Packet& same = all[3 - packets + i];
      EXPECT_EQ(given[i].header.SerializeAsString(), same.header.SerializeAsString());
      EXPECT_EQ(*given[i].payload, *same.payload);
    }
  }
}

TEST_F(SensorPackets, EndsWithWhatIsInNoPacketYet) {
  SensorChannel channel(config_, source_, 0);
  auto change = intervalOf(1, kIntensity, 0.5f);
  change->t1 = std::chrono::milliseconds(2);
  const TimeNs end = change->t1;
  channel.process(StillView(std::move(change)).interval(), false);
  EXPECT_TRUE(channel.takePackets().empty());
  const std::vector<Packet> last = channel.end(end, 1, v1::END_REASON_CLOSED);
  ASSERT_EQ(last.size(), 2u);
  EXPECT_EQ(last[0].header.count(), channel.items());
  EXPECT_EQ(last[1].header.kind(), v1::KIND_END);
  EXPECT_EQ(last[1].header.end_reason(), v1::END_REASON_CLOSED);
  EXPECT_EQ(last[1].header.t1_ns(), 2'000'000);
}

}  // namespace
}  // namespace saccade
