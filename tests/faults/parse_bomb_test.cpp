// Requests that are small on the wire and large once they are parsed.
#include <gtest/gtest.h>

#include <fstream>

#include "mock/server_process.h"
#include "mock/test_server.h"

namespace saccade {
namespace {

constexpr std::int64_t kMaxGrowthKib = 100 << 10;
constexpr std::chrono::milliseconds kSoon{500};  // the host of a test may stand still

std::int64_t peakKib(pid_t pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  for (std::string word; status >> word;) {
    std::int64_t kib = 0;
    if (word == "VmHWM:" && status >> kib) return kib;
  }
  return 0;
}

// 8.8 MiB of sensors of two bytes each.
std::string bomb(std::uint32_t version) {
  v1::Request request;
  request.set_protocol_version(version);
  const std::size_t sensors = 4'600'000;
  std::string bytes = request.SerializeAsString() + '\x5a';  // open_stream
  for (std::size_t left = 2 * sensors; left > 0; left >>= 7)
    bytes += static_cast<char>((left & 127) | (left > 127 ? 128 : 0));
  for (std::size_t i = 0; i < sensors; ++i) bytes += std::string("\x3a\0", 2);
  return bytes;
}

TEST(ParseBomb, IsRefusedAtOnce) {
  ServerProcess server;
  MockClient client(server.control()), other(server.control());
  client.close(client.open(tinyRequest()));
  const std::int64_t before = peakKib(server.process().pid());
  for (const std::uint32_t version : {1u, 2u}) {
    zmq::context_t context;
    zmq::socket_t peer(context, zmq::socket_type::dealer);
    peer.set(zmq::sockopt::linger, 0);
    peer.connect(server.control());
    const std::string bytes = bomb(version);
    for (int i = 0; i < 3; ++i) peer.send(zmq::buffer(bytes));
    std::chrono::nanoseconds longest{0};
    for (int i = 0; i < 3; ++i) {
      zmq::pollitem_t items[] = {{peer, 0, ZMQ_POLLIN, 0}};
      while (zmq::poll(items, 1, std::chrono::milliseconds(0)) == 0) {
        const auto began = std::chrono::steady_clock::now();
        other.server();
        longest = std::max<std::chrono::nanoseconds>(longest, std::chrono::steady_clock::now() - began);
      }
      zmq::message_t part;
      v1::Reply reply;
      ASSERT_TRUE(peer.recv(part) && reply.ParseFromString(part.to_string()));
      EXPECT_EQ(reply.status().field(), version == 1 ? "sensors" : "protocol_version");
    }
    EXPECT_LT(longest, kSoon);
  }
  if (kSanitized) return;  // sanitizers keep what is freed
  EXPECT_LT(peakKib(server.process().pid()) - before, kMaxGrowthKib);
}

// A client's text is repeated only as far as it helps to recognise it.
TEST(Echo, IsShort) {
  TestServer server;
  v1::Request request;
  request.mutable_close_stream()->set_stream_id(std::string(200, 'x'));
  const v1::Status status = server.client().call(request).status();
  EXPECT_EQ(status.code(), v1::CODE_NOT_FOUND);
  EXPECT_NE(status.message().find(std::string(64, 'x')), std::string::npos);
  EXPECT_EQ(status.message().find(std::string(65, 'x')), std::string::npos);
  v1::OpenStream open = tinyRequest();
  (*open.mutable_method()->mutable_params())[std::string(200, 'x')] = 1;
  const v1::Status param = server.client().tryOpen(open);
  EXPECT_NE(param.field().find(std::string(64, 'x')), std::string::npos);
  EXPECT_EQ((param.field() + param.message()).find(std::string(65, 'x')), std::string::npos);
}

}  // namespace
}  // namespace saccade
