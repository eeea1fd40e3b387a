#include "ops/service_manager.h"

#include <gtest/gtest.h>

#include "mock/mock_service_manager.h"

namespace saccade {
namespace {

TEST(ServiceManager, HearsWhatItIsTold) {
  const MockServiceManager manager;
  const ServiceManager service;
  service.tell("READY=1");
  service.tell("WATCHDOG=1");
  EXPECT_EQ(manager.next(), "READY=1");
  EXPECT_EQ(manager.next(), "WATCHDOG=1");
}

TEST(ServiceManager, NobodyNeedsToListen) {
  unsetenv("NOTIFY_SOCKET");
  EXPECT_NO_THROW(ServiceManager().tell("READY=1"));
  setenv("NOTIFY_SOCKET", "/nowhere/at/all", 1);
  EXPECT_NO_THROW(ServiceManager().tell("READY=1"));
  unsetenv("NOTIFY_SOCKET");
}

}  // namespace
}  // namespace saccade
