// Many receivers at once, in one process with one socket each.
#include <gtest/gtest.h>

#include <deque>

#include "mock/needs_libzmq.h"
#include "mock/server_process.h"
#include "mock/test_server.h"

namespace saccade {
namespace {

constexpr int kSubscribers = 200, kClients = 32;
constexpr double kStreamSeconds = 1.5;

v1::OpenStream pacedRequest(v1::Delivery delivery) {
  v1::OpenStream request = tinyRequest();
  request.set_delivery(delivery);
  request.mutable_timing()->set_clock(v1::CLOCK_PACED);
  request.mutable_timing()->set_frame_rate_hz(100);
  request.mutable_timing()->set_duration_s(kStreamSeconds);
  return request;
}

// A message of a socket that is ready: [topic] header payload.
Received receive(zmq::socket_t& socket, bool with_topic) {
  std::vector<std::string> parts;
  zmq::message_t part;
  do {
    EXPECT_TRUE(socket.recv(part));
    parts.push_back(part.to_string());
  } while (part.more());
  if (parts.size() != (with_topic ? 3u : 2u)) throw std::runtime_error("a message of so many parts");
  Received packet;
  if (with_topic) packet.topic = parts.front();
  packet.payload = parts.back();
  const std::string& header = parts[parts.size() - 2];
  packet.bytes = header.size() + packet.payload.size();
  if (!packet.header.ParseFromString(header)) throw std::runtime_error("a broken header");
  return packet;
}

class FanOut : public testing::Test {
 protected:
  zmq::socket_t& addSocket(zmq::socket_type type, const std::string& endpoint) {
    sockets_.emplace_back(context_, type);
    sockets_.back().set(zmq::sockopt::linger, 0);
    sockets_.back().connect(endpoint);
    return sockets_.back();
  }
  static void say(zmq::socket_t& socket, const v1::DataRequest& request) {
    socket.send(zmq::buffer(request.SerializeAsString()));
  }
  static void giveCredit(zmq::socket_t& socket, std::uint64_t bytes) {
    v1::DataRequest request;
    request.mutable_credit()->set_bytes(bytes);
    say(socket, request);
  }
  // The packets of each socket, to its END.
  std::vector<Packets> receiveAll(bool broadcast) {
    std::vector<Packets> all(sockets_.size());
    std::vector<zmq::pollitem_t> items;
    for (auto& socket : sockets_) items.push_back({socket, 0, ZMQ_POLLIN, 0});
    for (std::size_t ended = 0; ended < sockets_.size();) {
      if (zmq::poll(items, kPatience) == 0) throw std::runtime_error("no packet came");
      for (std::size_t i = 0; i < items.size(); ++i) {
        if (!items[i].revents) continue;
        Received packet = receive(sockets_[i], broadcast);
        if (packet.header.kind() == v1::KIND_HEARTBEAT) continue;
        if (!broadcast) giveCredit(sockets_[i], packet.bytes);
        ended += packet.header.kind() == v1::KIND_END;
        all[i].push_back(std::move(packet));
      }
    }
    return all;
  }

  ServerProcess server_;
  MockClient client_{server_.control()};
  zmq::context_t context_;
  std::deque<zmq::socket_t> sockets_;
};

// A late subscriber begins late; from there on a stream that fits the server's queues has no gap.
TEST_F(FanOut, ABroadcastReachesAllItsSubscribers) {
  NEEDS_PATCHED_LIBZMQ();
  const auto stream = client_.open(pacedRequest(v1::DELIVERY_BROADCAST));
  for (int i = 0; i < kSubscribers; ++i) {
    addSocket(zmq::socket_type::sub, server_.broadcast()).set(zmq::sockopt::subscribe, stream.topics(0));
  }
  const auto all = receiveAll(true);
  const v1::StreamInfo info = client_.info(stream.stream_id());
  for (const Packets& packets : all) {
    const v1::PacketHeader& first = packets.front().header;
    std::uint64_t seq = first.seq(), index = first.first_event_index(), events = 0;
    for (const Received& packet : packets) {
      EXPECT_EQ(packet.header.seq(), seq++);
      EXPECT_EQ(packet.header.first_event_index(), index + events);
      events += packet.header.count();
    }
    EXPECT_EQ(index + events, info.events());
  }
  EXPECT_EQ(info.frames_done(), stream.frames());
}

TEST_F(FanOut, ManyLiveClientsMissNothingThatIsNotCounted) {
  std::vector<v1::StreamOpened> streams;
  for (int i = 0; i < kClients; ++i) {
    streams.push_back(client_.open(pacedRequest(v1::DELIVERY_LIVE)));
    zmq::socket_t& socket = addSocket(zmq::socket_type::dealer, server_.data());
    v1::DataRequest request;
    request.mutable_attach()->set_stream_id(streams[i].stream_id());
    request.mutable_attach()->set_token(streams[i].token());
    say(socket, request);
    giveCredit(socket, 1 << 20);
  }
  const auto all = receiveAll(false);
  for (int i = 0; i < kClients; ++i) {
    const Summary summary = checkPackets(all[i], true, all[i].front().header.t0_ns());
    const v1::StreamInfo info = client_.info(streams[i].stream_id());
    EXPECT_EQ(summary.dropped, info.dropped_packets());
    EXPECT_EQ(summary.dropped == 0, summary.events == info.events());
  }
}

}  // namespace
}  // namespace saccade
