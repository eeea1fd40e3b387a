#include "stream/endpoint.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

TEST(Endpoint, LoopbackIsWhatOnlyThisMachineReaches) {
  for (const char* endpoint :
       {"tcp://127.0.0.1:5770", "tcp://127.8.0.1:*", "tcp://[::1]:5770", "tcp://localhost:5770",
        "ipc:///run/saccade/control", "http://127.0.0.1:5773", "http://localhost:5773"}) {
    EXPECT_TRUE(isLoopback(endpoint)) << endpoint;
  }
  for (const char* endpoint :
       {"tcp://0.0.0.0:5770", "tcp://*:5770", "tcp://[::]:5770", "tcp://10.0.0.1:5770", "tcp://eth0:5770",
        "tcp://lo:5770", "tcp://localhost.evil.org:5770", "tcp://127.evil.org:5770",
        "tcp://[::ffff:10.0.0.1]:5770", "http://0.0.0.0:80", "127x"}) {
    EXPECT_FALSE(isLoopback(endpoint)) << endpoint;
  }
}

TEST(Endpoint, LocalhostIsBoundByItsNumber) {
  EXPECT_EQ(bindable("tcp://localhost:5770"), "tcp://127.0.0.1:5770");
  EXPECT_EQ(bindable("tcp://[::1]:5770"), "tcp://[::1]:5770");
  EXPECT_EQ(bindable("ipc://localhost"), "ipc://localhost");
}

TEST(Endpoint, AWildcardIsReachedOnLoopback) {
  EXPECT_EQ(reachableHere("tcp://0.0.0.0:5770"), "tcp://127.0.0.1:5770");
  EXPECT_EQ(reachableHere("tcp://[::]:5770"), "tcp://[::1]:5770");
  EXPECT_EQ(reachableHere("tcp://10.0.0.1:5770"), "tcp://10.0.0.1:5770");
  EXPECT_EQ(reachableHere("ipc:///run/saccade/control"), "ipc:///run/saccade/control");
}

}  // namespace
}  // namespace saccade
