#include "client/subscriber.h"

#include <gtest/gtest.h>

#include <utility>

#include "fake_server.h"

namespace saccade {
namespace {

using std::chrono::seconds;

const PacketCutter::Source kSource{"s1", 9, 0, 346, 260};

class SubscriberTest : public testing::Test {
 protected:
  // A client that is attached, its attach and first credit read.
  Subscriber attach(std::uint64_t credit) {
    Subscriber client(context_, {server_.endpoint(), "s1", "secret", credit});
    const auto attach = server_.receive().attach();
    EXPECT_EQ(attach.stream_id(), "s1");
    EXPECT_EQ(attach.token(), "secret");
    EXPECT_EQ(server_.receive().credit().bytes(), credit);
    return client;
  }

  Packet nextPacket() {
    const std::int64_t t0 = std::exchange(t_ns_, t_ns_ + kPacketTimeNs);
    return cutter_.cut(Events{{t0, 1, 2, 1}}, {t0, t_ns_, 0, 0}).at(0);
  }

  static std::uint64_t bytesOf(const Packet& packet) {
    return packet.header.ByteSizeLong() + packet.payload->size();
  }

  std::string faultOf(Subscriber& client, const Packet& packet) {
    server_.send(packet);
    try {
      client.receive(seconds(10));
    } catch (const StreamFault& fault) {
      return fault.what();
    }
    return "no fault";
  }

  zmq::context_t context_;
  FakeServer server_{context_};
  PacketCutter cutter_{kSource};
  std::int64_t t_ns_ = 0;
};

TEST_F(SubscriberTest, DecodesWhatArrives) {
  Subscriber client = attach(1000);
  server_.send(nextPacket());
  const auto batch = client.receive(seconds(10));
  ASSERT_TRUE(batch);
  EXPECT_EQ(batch->header.seq(), 0u);
  EXPECT_EQ(batch->events, (Events{{0, 1, 2, 1}}));
}

TEST_F(SubscriberTest, NothingArrivesInTime) {
  Subscriber client = attach(1000);
  EXPECT_FALSE(client.receive(std::chrono::milliseconds(0)));
}

TEST_F(SubscriberTest, RefillsCreditAtHalf) {
  const std::uint64_t kCredit = 1000;
  Subscriber client = attach(kCredit);
  for (int round = 0; round < 3; ++round) {
    std::uint64_t sent = 0;
    while (sent < kCredit / 2) {
      const Packet packet = nextPacket();
      sent += bytesOf(packet);
      server_.send(packet);
      ASSERT_TRUE(client.receive(seconds(10)));
    }
    // One message a round, of all that arrived: earlier refills would have come first and been smaller.
    EXPECT_EQ(server_.receive().credit().bytes(), sent);
  }
}

TEST_F(SubscriberTest, CountsGaps) {
  Subscriber client = attach(1 << 20);
  for (const bool lost : {false, true, true, false, true, false}) {
    const Packet packet = nextPacket();
    if (lost) continue;
    server_.send(packet);
    ASSERT_TRUE(client.receive(seconds(10)));
  }
  EXPECT_EQ(client.losses().gaps, 2u);
  EXPECT_EQ(client.losses().packets, 3u);
  EXPECT_EQ(client.losses().events, 3u);
}

TEST_F(SubscriberTest, AnErrorOfTheStreamIsThrownWithItsText) {
  Subscriber client = attach(1000);
  EXPECT_EQ(faultOf(client, makeErrorPacket("s1", "wrong token")), "wrong token");
}

TEST_F(SubscriberTest, BadPacketsAreFaults) {
  Subscriber client = attach(1 << 20);
  Packet damaged = nextPacket();
  damaged.header.set_crc32(damaged.header.crc32() ^ 1);
  EXPECT_NE(faultOf(client, damaged).find("crc32"), std::string::npos);
  Packet outside = nextPacket();
  outside.header.set_width(1);
  EXPECT_NE(faultOf(client, outside).find("pixel"), std::string::npos);
}

TEST_F(SubscriberTest, AMessageThatIsNoPacketIsAFault) {
  Subscriber client = attach(1000);
  server_.send(v1::PacketHeader());
  EXPECT_THROW(client.receive(seconds(10)), StreamFault);
}

TEST_F(SubscriberTest, ListensToTopics) {
  zmq::socket_t publisher(context_, zmq::socket_type::xpub);
  publisher.set(zmq::sockopt::rcvtimeo, 10000);
  publisher.bind("tcp://127.0.0.1:*");
  Subscriber client(context_, publisher.get(zmq::sockopt::last_endpoint), {"s/s1/0/"});
  zmq::message_t subscription;
  ASSERT_TRUE(publisher.recv(subscription));
  EXPECT_EQ(subscription.to_string(), "\x01s/s1/0/");
  const Packet packet = nextPacket();
  publisher.send(zmq::str_buffer("s/s1/0/"), zmq::send_flags::sndmore);
  publisher.send(zmq::buffer(packet.header.SerializeAsString()), zmq::send_flags::sndmore);
  publisher.send(zmq::buffer(*packet.payload), zmq::send_flags::none);
  const auto batch = client.receive(seconds(10));
  ASSERT_TRUE(batch);
  EXPECT_EQ(batch->events.size(), 1u);
}

}  // namespace
}  // namespace saccade
