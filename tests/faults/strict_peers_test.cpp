// Peers that speak ZMTP by hand and break its rules, against the loop that all sockets have.
#include <gtest/gtest.h>

#include "faults/echo_router.h"
#include "mock/needs_libzmq.h"
#include "mock/zmtp_peer.h"
#include "stream/refused_connections.h"

namespace saccade {
namespace {

using std::chrono::milliseconds;

// The name that libzmq gives to the peer after so many more.
std::string nameAfter(std::string name, std::uint32_t steps) {
  std::uint32_t number = 0;
  for (int i = 1; i < 5; ++i) number = number << 8 | static_cast<unsigned char>(name[i]);
  number += steps;
  for (int i = 4; i > 0; --i, number >>= 8) name[i] = static_cast<char>(number);
  return name;
}

// A name that ZeroMQ was about to give to another ended the process. And a peer that came next under the name
// of one who has gone had its packets.
TEST(StrictPeers, NoPeerHasANameOfItsOwn) {
  NEEDS_PATCHED_LIBZMQ();
  EchoRouter router;
  ZmtpPeer first(router.endpoint());
  first.say(zmtp::part("hello"));
  ASSERT_TRUE(router.heard(1));
  const std::string name = *router.names().begin();
  std::vector<ZmtpPeer> thieves;
  for (std::uint32_t i = 0; i < 40; ++i)
    thieves.emplace_back(router.endpoint(), "DEALER", nameAfter(name, i));
  for (auto& thief : thieves) thief.say(zmtp::part("hello"));
  ASSERT_TRUE(router.heard(41));
  std::vector<ZmtpPeer> honest;
  for (int i = 0; i < 40; ++i) honest.emplace_back(router.endpoint());
  for (auto& peer : honest) peer.say(zmtp::part("hello"));
  EXPECT_TRUE(router.heard(81)) << "two peers have one name";
}

TEST(StrictPeers, TheEndOfAConnectionIsTold) {
  NEEDS_PATCHED_LIBZMQ();
  EchoRouter router;
  {
    ZmtpPeer peer(router.endpoint());
    peer.say(zmtp::part("hello"));
    ASSERT_TRUE(router.heard(1));
  }
  EXPECT_TRUE(router.gone(1));
}

TEST(StrictPeers, AnEmptyMessageIsNotTheEnd) {
  EchoRouter router;
  ZmtpPeer peer(router.endpoint());
  peer.say(zmtp::part(""));
  ASSERT_TRUE(router.heard(1));
  peer.say(zmtp::part("hello"));
  EXPECT_EQ(peer.hear(9), zmtp::part("") + zmtp::part("hello"));
}

// More messages than the queue holds, and the end of the connection right behind them.
TEST(StrictPeers, TheEndOfAConnectionIsToldBehindAFullQueue) {
  NEEDS_PATCHED_LIBZMQ();
  EchoRouter router;
  {
    ZmtpPeer peer(router.endpoint());
    std::string many;
    for (int i = 0; i < 5000; ++i) many += zmtp::part("hello");
    peer.say(many);
    ASSERT_TRUE(router.heard(1));
  }
  EXPECT_TRUE(router.gone(1));
}

struct Rule {
  const char* name;
  std::string greeting, rest;
};
void PrintTo(const Rule& rule, std::ostream* out) {
  *out << rule.name;
}

class BreakARule : public testing::TestWithParam<Rule> {};

TEST_P(BreakARule, EndsTheConnectionAndNoOther) {
  NEEDS_PATCHED_LIBZMQ();
  EchoRouter router;
  ZmtpPeer honest(router.endpoint());
  honest.say(zmtp::part("hello"));
  ASSERT_TRUE(router.heard(1));
  const int refused = refusedConnections();
  RawPeer peer(router.endpoint());
  peer.say(GetParam().greeting);
  peer.hear(1, kPatience);
  peer.say(GetParam().rest);
  EXPECT_TRUE(peer.closed(kBeforeHeartbeats));
  EXPECT_GE(refusedConnections(), refused + 1);
  honest.say(zmtp::part("hello"));
  EXPECT_FALSE(honest.closed(milliseconds(100)));
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

INSTANTIATE_TEST_SUITE_P(
    StrictPeers, BreakARule,
    testing::Values(Rule{"LongHandshake", zmtp::greeting(),
                         zmtp::command("READY", repeated(zmtp::property("X", "y"), 2000))},
                    Rule{"LongHandshakeAsAMessage", zmtp::greeting(),
                         zmtp::part("\5READY" + repeated(zmtp::property("X", "y"), 2000))},
                    Rule{"OlderProtocol", zmtp::greeting(1), repeated(zmtp::part("x"), 10)},
                    Rule{"Unversioned", std::string("\1\0", 2), repeated(zmtp::part("x"), 10)}),
    [](const auto& rule) { return rule.param.name; });

TEST(StrictPeers, AMessageWithoutEndEndsItsConnection) {
  NEEDS_PATCHED_LIBZMQ();
  EchoRouter router;
  ZmtpPeer peer(router.endpoint());
  peer.say(repeated(zmtp::part("x", true), 100));
  EXPECT_TRUE(peer.closed(kBeforeHeartbeats));
  EXPECT_TRUE(router.names().empty());
}

// The PONG to a PING without the fields it must have held what lies behind it in memory.
TEST(StrictPeers, AShortPingIsNotAnswered) {
  NEEDS_PATCHED_LIBZMQ();
  EchoRouter router;
  ZmtpPeer peer(router.endpoint());
  peer.say(zmtp::command("PING", {}));
  peer.say(zmtp::part("hello"));
  EXPECT_EQ(peer.hear(zmtp::part("hello").size()), zmtp::part("hello"));
}

TEST(StrictPeers, ConnectionsAreBounded) {
  NEEDS_PATCHED_LIBZMQ();
  EchoRouter router({.keys = {}, .connections = 4});
  std::vector<ZmtpPeer> peers;
  for (int i = 0; i < 4; ++i) peers.emplace_back(router.endpoint()).say(zmtp::part("hello"));
  ASSERT_TRUE(router.heard(4));
  EXPECT_TRUE(ZmtpPeer(router.endpoint()).closed(kBeforeHeartbeats));
  peers.pop_back();
  ASSERT_TRUE(router.gone(1));
  // The end of a connection is told before its place is free: until then others are closed.
  const std::string hello = zmtp::part("hello");
  std::string answer;
  for (int i = 0; i < 1000 && answer != hello; ++i) {
    ZmtpPeer late(router.endpoint());
    late.say(hello);
    answer = late.hear(hello.size());
  }
  EXPECT_EQ(answer, hello);
}

TEST(StrictPeers, ConnectionsOfOneAddressAreBounded) {
  NEEDS_PATCHED_LIBZMQ();
  EchoRouter router({.keys = {}, .client_connections = 2});
  std::vector<ZmtpPeer> peers;
  for (int i = 0; i < 2; ++i) peers.emplace_back(router.endpoint()).say(zmtp::part("hello"));
  ASSERT_TRUE(router.heard(2));
  ZmtpPeer third(router.endpoint());
  third.say(zmtp::part("hello"));
  EXPECT_TRUE(third.closed(kBeforeHeartbeats));
  peers.clear();
  ASSERT_TRUE(router.gone(2));
  ZmtpPeer late(router.endpoint());
  late.say(zmtp::part("hello"));
  EXPECT_TRUE(router.heard(3));
}

}  // namespace
}  // namespace saccade
