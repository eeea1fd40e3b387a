// Feeds of methods that keep pictures stay within what a server counts for them, see stream_cost.cpp.
#include <gtest/gtest.h>
#include <malloc.h>

#include "feed/feed.h"
#include "feed/room.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;
constexpr int kWidth = 160, kHeight = 120;
constexpr double kFeedBytes = 260;  // per pixel, border included
constexpr double kOther = 3e5;      // lists of tasks, paths, tables

double bytesInUse() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

TEST(MethodMemory, HoldsWhatTheTableSays) {
  TilePool pool(1);
  const auto scene = test::room();
  const Trajectory path({{0ms, Pose{{0, 0, -0.9}, {}}}, {1000ms, Pose{{0.5, 0, -0.9}, {}}}});
  // The first feed makes what threads keep.
  for (const char* name : {"pt", "event_svgf", "svgf", "relax", "a_svgf", "adaptive_denoising",
                           "adaptive_sampling", "oidn", "learned"}) {
    const MethodInfo* found = findMethod(name);
    if (!found) continue;  // its library is absent
    const MethodInfo& method = *found;
    FeedConfig config;
    config.camera = pinhole(80, kWidth, kHeight), config.frame_rate_hz = 100, config.method = name;
    std::string bad;
    ASSERT_EQ(resolveParams(method, {}, config.params, bad), "");
    const double before = bytesInUse();
    Feed feed(scene, path, config, pool);
    for (int t = 1; t <= 3; ++t) feed.step(pool);
    const double counted = kFeedBytes * (kWidth + 64) * (kHeight + 64) +
                           method.memory(config.params, {1. * kWidth * kHeight, false, false});
    EXPECT_LE(bytesInUse() - before, counted + (name == std::string("pt") ? 1e7 : kOther)) << name;
  }
}

}  // namespace
}  // namespace saccade
