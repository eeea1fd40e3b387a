#include "saccade/subscriber.h"

#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "fake_server.h"

namespace saccade::client {
namespace {

using std::chrono::seconds;

const PacketSource kSource{"s1", 9, 0, 346, 260};

class SubscriberTest : public testing::Test {
 protected:
  // A client that is attached, its attach and first credit read.
  Subscriber attach(std::uint64_t credit) {
    Subscriber client(context_, {server_.endpoint(), "s1", "secret", {4, 7}, credit});
    const auto attach = server_.receive().attach();
    EXPECT_EQ(attach.stream_id(), "s1");
    EXPECT_EQ(attach.token(), "secret");
    EXPECT_EQ(std::vector(attach.from_seqs().begin(), attach.from_seqs().end()),
              (std::vector<std::uint64_t>{4, 7}));
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

  // Until nothing more comes. Returns the last fault.
  static std::string receiveAll(Subscriber& client) {
    std::string fault;
    for (bool more = true; more;) {
      try {
        more = client.receive(std::chrono::milliseconds(100)).has_value();
      } catch (const StreamFault& one) {
        fault = one.what();
      }
    }
    return fault;
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

// The packet that was received last is not yet safe: the client may still be writing it.
TEST_F(SubscriberTest, RefillsCreditAtHalfAndAcknowledgesWhatIsSafe) {
  const std::uint64_t kCredit = 1000;
  Subscriber client = attach(kCredit);
  for (int round = 0; round < 3; ++round) {
    std::uint64_t sent = 0, last_seq = 0;
    while (sent < kCredit / 2) {
      const Packet packet = nextPacket();
      sent += bytesOf(packet);
      last_seq = packet.header.seq();
      server_.send(packet);
      ASSERT_TRUE(client.receive(seconds(10)));
    }
    EXPECT_TRUE(server_.saysNothing(std::chrono::milliseconds(10)));
    EXPECT_FALSE(client.receive(seconds(0)));
    // One of each a round, of all that arrived: earlier ones would have come first and been smaller.
    EXPECT_EQ(server_.receive().ack().seq(), last_seq);
    EXPECT_EQ(server_.receive().credit().bytes(), sent);
  }
}

TEST_F(SubscriberTest, EachSensorIsAcknowledged) {
  Subscriber client = attach(100);
  for (const std::uint32_t sensor : {0u, 1u}) {
    Packet packet = nextPacket();
    packet.header.set_sensor(sensor);
    packet.header.set_seq(8 + sensor);
    server_.send(packet);
    ASSERT_TRUE(client.receive(seconds(10)));
  }
  client.receive(seconds(0));
  std::map<std::uint32_t, std::uint64_t> seqs;
  for (int i = 0; i < 4; ++i) {
    const v1::DataRequest request = server_.receive();
    if (request.has_ack()) seqs[request.ack().sensor()] = request.ack().seq();
  }
  EXPECT_EQ(seqs, (std::map<std::uint32_t, std::uint64_t>{{0, 8}, {1, 9}}));
}

TEST_F(SubscriberTest, HeartbeatsCostNothing) {
  Subscriber client = attach(10);
  v1::PacketHeader heartbeat;
  heartbeat.set_kind(v1::KIND_HEARTBEAT);
  heartbeat.set_frame(12);
  server_.send(sealPacket(heartbeat, {}));
  const auto batch = client.receive(seconds(10));
  ASSERT_TRUE(batch);
  EXPECT_EQ(batch->header.frame(), 12u);
  client.receive(seconds(0));
  EXPECT_TRUE(server_.saysNothing(std::chrono::milliseconds(10)));
}

TEST_F(SubscriberTest, ManyHeartbeatsAreOne) {
  Subscriber client = attach(10);
  v1::PacketHeader heartbeat;
  heartbeat.set_kind(v1::KIND_HEARTBEAT);
  constexpr std::uint64_t kBeats = 50'000;
  for (std::uint64_t i = 1; i <= kBeats; ++i) {
    heartbeat.set_frame(i);
    server_.send(sealPacket(heartbeat, {}));
  }
  std::uint64_t received = 0, last = 0;
  for (; last < kBeats; ++received) {
    const auto batch = client.receive(seconds(10));
    ASSERT_TRUE(batch);
    EXPECT_GT(batch->header.frame(), last);
    last = batch->header.frame();
  }
  EXPECT_LT(received, kBeats / 2);
}

// Of many packets that are sent at once, some wait together before the client gives anything back.
TEST_F(SubscriberTest, WhatIsSentWithoutCreditIsAFault) {
  Subscriber client = attach(1000);
  std::string fault;
  for (int flood = 0; flood < 1000 && fault.empty(); ++flood) {
    for (int i = 0; i < 200; ++i) server_.send(nextPacket());
    fault = receiveAll(client);
  }
  EXPECT_EQ(fault, "the server sends more than it has credit for");
}

// The last packet may overdraw the credit, however large it is.
TEST_F(SubscriberTest, AnOverdraftIsNoFault) {
  Subscriber client = attach(100);
  const Packet small = nextPacket();
  ASSERT_LT(bytesOf(small), 100u);
  Packet large =
      cutter_.cut(Events(1000, Event{kPacketTimeNs, 1, 2, 1}), {kPacketTimeNs, 2 * kPacketTimeNs, 0, 0})
          .at(0);
  ASSERT_GT(bytesOf(large), 9000u);
  server_.send(small);
  server_.send(large);
  EXPECT_TRUE(client.receive(seconds(10)));
  EXPECT_TRUE(client.receive(seconds(10)));
}

TEST_F(SubscriberTest, AnErrorIsThrownWithItsText) {
  Subscriber client = attach(1000);
  EXPECT_EQ(faultOf(client, makeErrorPacket("s1", "wrong token")), "wrong token");
}

TEST_F(SubscriberTest, AnErrorMayBeOfTheConnectionAlone) {
  Subscriber client = attach(1000);
  for (const std::string stream : {"", "s1"}) {
    server_.send(makeErrorPacket(stream, "attach first"));
    try {
      client.receive(seconds(10));
      FAIL() << "no fault";
    } catch (const StreamRefused& refused) {
      EXPECT_EQ(refused.connection_only, stream.empty());
    }
  }
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
}  // namespace saccade::client
