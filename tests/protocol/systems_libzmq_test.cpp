// A server with the system's libzmq, which trusts the programs of its own machine and nobody else.
#include <gtest/gtest.h>

#include <mutex>
#include <set>

#include "app/config/keys.h"
#include "mock/keyed_server.h"
#include "mock/needs_libzmq.h"
#include "mock/process.h"
#include "mock/test_server.h"
#include "mock/wait_until.h"
#include "mock/zmtp_peer.h"
#include "stream/socket_loop.h"

namespace saccade {
namespace {

// Keys do not help: the bytes of strangers come before the handshake.
TEST_F(KeyedServer, IsForThisMachineAloneWithTheSystemsLibzmq) {
  NEEDS_SYSTEMS_LIBZMQ();
  Config insecure = testConfig();
  insecure.insecure = true;
  for (Config config : {config_, insecure}) {
    EXPECT_NO_THROW(openAccess(config));
    config.broadcast = "tcp://0.0.0.0:*";
    try {
      openAccess(config);
      ADD_FAILURE() << "it would serve other machines";
    } catch (const std::runtime_error& fault) {
      const std::string why = fault.what();
      EXPECT_TRUE(why.starts_with("--broadcast: tcp://0.0.0.0:*")) << why;
      EXPECT_NE(why.find("deploy/libzmq/build"), std::string::npos) << why;
    }
  }
}

TEST(SystemsLibzmq, RefusesBroadcastsAndNamesTheField) {
  NEEDS_SYSTEMS_LIBZMQ();
  TestServer server;
  v1::OpenStream request = tinyRequest();
  request.set_delivery(v1::DELIVERY_BROADCAST);
  const v1::Status status = server.client().tryOpen(request);
  EXPECT_EQ(status.code(), v1::CODE_INVALID_ARGUMENT);
  EXPECT_EQ(status.field(), "delivery");
}

TEST(SystemsLibzmq, IsToldInTheLogAndInTheHelp) {
  NEEDS_SYSTEMS_LIBZMQ();
  for (const char* option : {"--help", "--http=off"}) {
    Process server({SACCADED, option, "--control=tcp://127.0.0.1:*", "--data=tcp://127.0.0.1:*",
                    "--broadcast=tcp://127.0.0.1:*"});
    EXPECT_NE(server.lineWith("system's libzmq"), "") << option;
  }
}

// The library does not tell the end of a connection. The kernel gives its descriptor to the next one.
TEST(SystemsLibzmq, APeerIsGoneOnceAnotherHasItsDescriptor) {
  NEEDS_SYSTEMS_LIBZMQ();
  std::mutex mutex;
  std::set<std::string> gone;
  SocketLoop loop({.endpoint = "tcp://127.0.0.1:*", .access = {}});
  loop.start([](SocketLoop::Message&&) {}, [] { return SocketLoop::kUntilWoken; },
             [&](const std::string& peer) {
               std::lock_guard lock(mutex);
               gone.insert(peer);
             });
  EXPECT_TRUE(waitUntil(
      [&] {
        ZmtpPeer(loop.endpoint()).say(zmtp::part("hello"));
        std::lock_guard lock(mutex);
        return gone.size() >= 3;
      },
      kPatience));
  loop.stop();
}

}  // namespace
}  // namespace saccade
