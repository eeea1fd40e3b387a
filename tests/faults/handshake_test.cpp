// Peers whose greetings, metadata and messages are not what they should be cost nobody a packet, and leave
// nothing behind.
#include <gtest/gtest.h>

#include "fuzz/draws.h"
#include "mock/raw_peer.h"
#include "mock/server_process.h"
#include "mock/test_server.h"
#include "mock/wait_until.h"
#include "mock/zmtp.h"

namespace saccade {
namespace {

constexpr int kPeers = 300;
constexpr std::size_t kGreetingBytes = 64;
constexpr std::chrono::milliseconds kMoment{5};

std::string mutated(std::string bytes, std::uint64_t mutant) {
  Draws draw(mutant);
  for (std::size_t changes = 1 + draw.below(6); changes > 0; --changes) {
    const std::size_t at = draw.below(bytes.size());
    if (draw.oneIn(3)) {
      bytes.erase(at, 1 + draw.below(8));
    } else if (draw.oneIn(2)) {
      bytes.insert(at, zmtp::bigEndian(draw.bits(), 1 + static_cast<int>(draw.below(8))));
    } else {
      bytes[at] = static_cast<char>(draw.below(256));
    }
    if (bytes.empty()) bytes = "\xFF";
  }
  return bytes;
}

// By hand, since libzmq says nothing wrong.
std::string introduction(const std::string& socket_type, const std::string& message) {
  return zmtp::greeting() + zmtp::ready(socket_type, zmtp::property("Identity", "")) +
         zmtp::frame(0, message);
}

TEST(Handshake, MutantsDisturbNoStreamAndLeaveNothingBehind) {
  ServerProcess server;
  MockClient client(server.control());
  v1::Request info;
  info.set_protocol_version(1);
  info.mutable_server_info();
  v1::DataRequest credit;
  credit.mutable_credit()->set_bytes(1 << 20);
  const std::pair<std::string, std::string> ends[] = {
      {server.control(), introduction("DEALER", info.SerializeAsString())},
      {server.data(), introduction("DEALER", credit.SerializeAsString())},
      {server.broadcast(), introduction("SUB", "\1s/0123456789abcdef/0/")}};
  v1::OpenStream request = tinyRequest();
  request.mutable_timing()->set_duration_s(0);
  const auto stream = client.open(request);
  MockSubscriber subscriber(server.data());
  subscriber.attach(stream);
  subscriber.giveCredit(1 << 30);
  Packets packets{*subscriber.receive()};
  const Usage before = server.usage();
  for (int i = 0; i < kPeers; ++i) {
    const auto& [endpoint, bytes] = ends[i % 3];
    RawPeer peer(endpoint);
    ASSERT_TRUE(peer.connected()) << "after " << i << " peers";
    const std::string bad = mutated(bytes, static_cast<std::uint64_t>(i));
    peer.say(bad.substr(0, kGreetingBytes));
    peer.hear(kGreetingBytes, kMoment);
    peer.say(bad.substr(std::min(bad.size(), kGreetingBytes)));
    peer.hear(kGreetingBytes, kMoment);  // it has been read by then, or never will
    if (i % 10 == 0) packets.push_back(*subscriber.receive());
  }
  EXPECT_EQ(client.server().threads(), 1u);
  EXPECT_TRUE(waitUntil([&] { return server.usage().fds <= before.fds; }, std::chrono::seconds(10)));
  EXPECT_EQ(server.usage().threads, before.threads);
  EXPECT_EQ(client.close(stream).code(), v1::CODE_OK);
  const auto rest = subscriber.receiveAll(1)[0];
  packets.insert(packets.end(), rest.begin(), rest.end());
  checkPackets(packets);
}

}  // namespace
}  // namespace saccade
