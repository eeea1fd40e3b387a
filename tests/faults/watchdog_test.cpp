// A thread of the server stands still: the service manager hears nothing any more, and would start it again.
//
// The program's own zmq_poll stands before the library's, so that a test can hold the threads that wait in
// it.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <mutex>

#include "mock/mock_service_manager.h"
#include "mock/test_server.h"

namespace {
std::mutex gate;  // held: who has waited in zmq_poll goes no further
}

extern "C" int zmq_poll(zmq_pollitem_t* items, int count, long timeout) {
  static const auto next = reinterpret_cast<decltype(&zmq_poll)>(dlsym(RTLD_NEXT, "zmq_poll"));
  const int result = next(items, count, timeout);
  const std::lock_guard pass(gate);
  return result;
}

namespace saccade {
namespace {

constexpr std::chrono::milliseconds kTick{1000};  // how often the manager is told
constexpr int kMany = 4;

TEST(Watchdog, StopsWhenAThreadStandsStill) {
  const MockServiceManager manager;
  TestServer server;
  EXPECT_EQ(manager.next(), "READY=1");
  EXPECT_EQ(manager.next(), "WATCHDOG=1");
  {
    const std::lock_guard hold(gate);
    int heard = 0;  // one may be on its way, and others unread
    while (heard < kMany && !manager.next(kTick + kTick / 2).empty()) ++heard;
    EXPECT_LT(heard, kMany);
    EXPECT_TRUE(server.app().alive());  // to people it says so only after kStall
  }
  EXPECT_EQ(manager.next(), "WATCHDOG=1");
  EXPECT_EQ(server.client().server().threads(), 1u);
}

}  // namespace
}  // namespace saccade
