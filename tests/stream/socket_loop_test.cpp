// The thread of a socket.
#include "stream/socket_loop.h"

#include <gtest/gtest.h>
#include <poll.h>

#include <future>

#include "mock/mock_client.h"
#include "mock/zmtp_peer.h"

namespace saccade {
namespace {

// Each of some hundred calls that wait took its time, and only then the server stopped.
TEST(SocketLoop, StopsBeforeTheNextMessage) {
  SocketLoop loop({.endpoint = "tcp://127.0.0.1:*", .access = {}});
  std::promise<void> taken;
  int messages = 0;
  loop.start(
      [&](SocketLoop::Message&&) {
        if (++messages > 1) return;
        taken.set_value();
        pollfd stopping{loop.wake().fd(), POLLIN, 0};
        poll(&stopping, 1, static_cast<int>(kPatience.count()));
      },
      [] { return SocketLoop::kUntilWoken; }, [](const std::string&) {});
  std::string many;
  for (int i = 0; i < 10; ++i) many += zmtp::part("call");
  ZmtpPeer peer(loop.endpoint());
  peer.say(many);  // one segment: when the first is taken, the others are there
  taken.get_future().wait();
  loop.stop();
  EXPECT_EQ(messages, 1);
}

}  // namespace
}  // namespace saccade
