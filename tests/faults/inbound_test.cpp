// Large messages on their way in, whose bytes all sockets share.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <future>
#include <utility>

#include "faults/echo_router.h"
#include "mock/mock_keys.h"
#include "mock/needs_libzmq.h"
#include "mock/wait_until.h"
#include "mock/zmtp_peer.h"
#include "stream/refused_connections.h"

namespace saccade {
namespace {

using std::chrono::milliseconds;

constexpr int kMiB = 1 << 20;

std::string largePart() {
  return zmtp::part(std::string(8 * kMiB - 1, 'x'));
}

// Large messages that never end: the bound of all of them together cuts those beyond it off.
TEST(Inbound, BoundsTheBytesOfMessagesThatAreStillArriving) {
  NEEDS_PATCHED_LIBZMQ();
  EchoRouter router({.keys = {}, .inbound_mib = 16}, 8 * kMiB);
  const std::string begun = largePart().substr(0, 5 * kMiB);  // more than half: there is room for all of it
  std::vector<ZmtpPeer> peers;
  for (int i = 0; i < 2; ++i) peers.emplace_back(router.endpoint()).say(begun);
  for (auto& peer : peers) EXPECT_FALSE(peer.closed(milliseconds(300)));
  ZmtpPeer third(router.endpoint());
  third.say(begun);
  EXPECT_TRUE(third.closed(kBeforeHeartbeats));
  peers.clear();
  EXPECT_TRUE(waitUntil(
      [&] {
        ZmtpPeer late(router.endpoint());
        late.say(begun);
        return !late.closed(milliseconds(200));
      },
      kPatience));
}

// Some hundred bytes of a few peers held all of the bound, and whoever sent a large message then was cut off.
TEST(Inbound, AnAnnouncedSizeTakesNoRoom) {
  NEEDS_PATCHED_LIBZMQ();
  EchoRouter router({.keys = {}, .inbound_mib = 16}, 8 * kMiB);
  const std::string hello = zmtp::part("hello"), large = largePart();
  std::vector<ZmtpPeer> liars;
  for (int i = 0; i < 30; ++i) {
    liars.emplace_back(router.endpoint()).say(hello + large.substr(0, 100));
    ASSERT_EQ(liars.back().hear(hello.size()), hello);  // so it has read what came with it, too
  }
  ZmtpPeer honest(router.endpoint());
  honest.say(large);
  EXPECT_EQ(honest.hear(large.size()), large);
  for (auto& liar : liars) EXPECT_FALSE(liar.closed(milliseconds(0)));
}

// Such as the sockets by which the viewer is a client of its own process.
TEST(Inbound, SocketsWithoutBoundsAreNotCutOff) {
  NEEDS_PATCHED_LIBZMQ();
  EchoRouter router({.keys = {}, .inbound_mib = 16}, 8 * kMiB);
  std::vector<ZmtpPeer> peers;
  for (int i = 0; i < 2; ++i) peers.emplace_back(router.endpoint()).say(largePart().substr(0, 5 * kMiB));
  ZmtpPeer third(router.endpoint());
  third.say(largePart());
  ASSERT_TRUE(third.closed(kBeforeHeartbeats));  // there is no room left
  zmq::context_t context;
  zmq::socket_t receiver(context, zmq::socket_type::pull), sender(context, zmq::socket_type::push);
  receiver.bind("tcp://127.0.0.1:*");
  receiver.set(zmq::sockopt::rcvtimeo, static_cast<int>(milliseconds(kPatience).count()));
  sender.connect(receiver.get(zmq::sockopt::last_endpoint));
  sender.send(zmq::message_t(8 * kMiB), zmq::send_flags::none);
  zmq::message_t received;
  ASSERT_TRUE(receiver.recv(received));
  EXPECT_EQ(received.size(), std::size_t{8 * kMiB});
}

// The thread that takes them is busy: decrypted messages count until then, like others.
TEST(Inbound, MessagesThatWaitCountWithKeysToo) {
  NEEDS_PATCHED_LIBZMQ();
  const MockKeys server = makeMockKeys(), client = makeMockKeys(server.public_key);
  const std::string list = testing::TempDir() + "strict_peers_" + std::to_string(getpid());
  std::ofstream(list) << client.public_key << "\n";
  std::promise<void> taken, may_go_on;
  const std::shared_future<void> go_on = may_go_on.get_future();
  SocketLoop loop(
      {.endpoint = "tcp://127.0.0.1:*",
       .max_part_bytes = 9 * kMiB,
       .access = {.keys = {{server.secret, std::make_shared<ClientKeys>(list)}}, .inbound_mib = 16}});
  std::filesystem::remove(list);
  loop.start(
      [&, first = true](SocketLoop::Message&&) mutable {
        if (std::exchange(first, false)) taken.set_value();
        go_on.wait();
      },
      [] { return SocketLoop::kUntilWoken; }, [](const std::string&) {});
  const int refused = refusedConnections();
  zmq::context_t context;
  zmq::socket_t sender(context, zmq::socket_type::dealer);
  sender.set(zmq::sockopt::linger, 0);
  client.apply(sender);
  sender.connect(loop.endpoint());
  sender.send(zmq::buffer("hello"), zmq::send_flags::none);
  taken.get_future().wait();
  for (int i = 0; i < 3; ++i) sender.send(zmq::message_t(8 * kMiB - 1), zmq::send_flags::none);
  EXPECT_TRUE(waitUntil([&] { return refusedConnections() > refused; }, kPatience));
  may_go_on.set_value();
  loop.stop();
}

}  // namespace
}  // namespace saccade
