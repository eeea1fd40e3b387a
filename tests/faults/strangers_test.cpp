// Peers that connect and say nothing, or something else than they should: they are cut off, and cost others
// nothing.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "mock/mock_http.h"
#include "mock/needs_libzmq.h"
#include "mock/raw_peer.h"
#include "mock/server_process.h"
#include "mock/test_server.h"
#include "mock/wait_until.h"

namespace saccade {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr seconds kServedAfter{1};
constexpr seconds kCutAfter{5 + 3};  // the handshake's time, and some
constexpr int kFewLines = 20;

std::vector<RawPeer> connectMany(const std::string& endpoint, int count) {
  std::vector<RawPeer> peers;
  for (int i = 0; i < count; ++i) peers.emplace_back(endpoint);
  return peers;
}

// 120 connections that say nothing, where only 64 files may be open.
TEST(Strangers, PeersThatTakeAllFilesDisturbNoStreamAndLetOthersInAfterwards) {
  if (kSanitized) GTEST_SKIP() << "the sanitizer itself needs a file to look at an object";
  ServerProcess server({}, {"/bin/sh", "-c", "ulimit -n 64; exec \"$@\"", "sh"});
  MockClient client(server.control());
  v1::OpenStream request = tinyRequest();
  request.mutable_timing()->set_duration_s(0);
  const auto stream = client.open(request);
  MockSubscriber subscriber(server.data());
  subscriber.attach(stream);
  subscriber.giveCredit(1 << 30);
  Packets packets{*subscriber.receive()};
  {
    const auto crowd = connectMany(server.control(), 120);
    ASSERT_TRUE(waitUntil([&] { return server.usage().fds >= 64; }, seconds(5)));
    for (int i = 0; i < 100; ++i) packets.push_back(*subscriber.receive());
    v1::OpenStream other = tinyRequest();  // its scene has to be read from a file
    other.set_scene("textured-cornell-box");
    EXPECT_NE(client.tryOpen(other).code(), v1::CODE_OK);
    EXPECT_EQ(client.server().threads(), 1u);
  }
  MockClient late(server.control());
  late.setPatience(kServedAfter);
  EXPECT_EQ(late.server().threads(), 1u);
  EXPECT_NE(httpGet(server.http(), "/metrics").body.find("\nprocess_max_fds 64\n"), std::string::npos);
  EXPECT_EQ(client.close(stream).code(), v1::CODE_OK);
  const auto rest = subscriber.receiveAll(1)[0];
  packets.insert(packets.end(), rest.begin(), rest.end());
  checkPackets(packets);
}

class StrangersAndKeys : public testing::Test {
 protected:
  StrangersAndKeys() {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ + "/server.key") << own_.secret;
    std::ofstream(folder_ + "/clients") << client_.public_key;
  }
  ~StrangersAndKeys() override { std::filesystem::remove_all(folder_); }

  const MockKeys own_ = makeMockKeys(), client_ = makeMockKeys(own_.public_key);
  const std::string folder_ = testing::TempDir() + "strangers_test_" + std::to_string(getpid());
};

// CVE-2020-15166: connections without a handshake once starved a server with keys.
TEST_F(StrangersAndKeys, PeersWithoutHandshakeAreCutOffAndStarveNoClient) {
  ServerProcess server({"--secret-key", folder_ + "/server.key", "--client-keys", folder_ + "/clients"});
  auto crowd = connectMany(server.control(), 200);
  MockClient client(server.control(), client_);
  client.setPatience(kServedAfter);
  EXPECT_EQ(client.server().threads(), 1u);
  const auto deadline = std::chrono::steady_clock::now() + kCutAfter;
  for (auto& peer : crowd) {
    const auto left = deadline - std::chrono::steady_clock::now();
    EXPECT_TRUE(peer.closed(std::max(milliseconds(0), std::chrono::duration_cast<milliseconds>(left))));
  }
}

const std::string kTlsHello("\x16\x03\x01\x00\x05\x01\x00\x00\x01\x03", 10);

std::vector<std::string> babble() {
  std::vector<std::string> all{"GET / HTTP/1.1\r\nHost: x\r\n\r\n", kTlsHello + std::string(300, 'x'),
                               std::string(4096, '\0'), std::string(4096, '\xff')};
  std::uint32_t state = 1;
  std::string noise;
  while (noise.size() < 64 << 10) noise += static_cast<char>((state = state * 1664525u + 1013904223u) >> 24);
  all.push_back(noise);
  return all;
}

TEST(Strangers, PeersWithAnotherProtocolAreCutOffAndDoNotFillTheLog) {
  NEEDS_PATCHED_LIBZMQ();
  ServerProcess server;
  std::vector<std::pair<std::string, RawPeer>> peers;
  int number = 0;
  for (const std::string& words : babble()) {
    for (const auto& [name, endpoint] : {std::pair("control", server.control()),
                                         {"data", server.data()},
                                         {"broadcast", server.broadcast()},
                                         {"http", server.http()}}) {
      for (int again = 0; again < 10; ++again) {
        peers.emplace_back(std::string(name) + " " + std::to_string(number), RawPeer(endpoint));
        peers.back().second.say(words);
      }
    }
    ++number;
  }
  const auto deadline = std::chrono::steady_clock::now() + kCutAfter;
  for (auto& [name, peer] : peers) {
    const auto left = deadline - std::chrono::steady_clock::now();
    EXPECT_TRUE(peer.closed(std::max(milliseconds(0), std::chrono::duration_cast<milliseconds>(left))))
        << name;
  }
  EXPECT_EQ(MockClient(server.control()).server().threads(), 1u);
  server.process().signal(SIGTERM);
  const std::string log = server.process().rest();
  EXPECT_LT(std::count(log.begin(), log.end(), '\n'), kFewLines) << log;
  EXPECT_EQ(server.process().finish(), 0);
}

}  // namespace
}  // namespace saccade
