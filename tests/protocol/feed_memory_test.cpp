// A feed without memory ends its streams, though it cannot even tell them why.
#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include "app/feeds/feed_runner.h"
#include "base/counting_new.h"
#include "feed/rig.h"
#include "mock/mock_client.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

// From the third frame on the feed's thread gets no memory.
class Greedy : public Method {
 public:
  void start(const Frame&, const PoolHandle&) override {}
  void estimate(const FramePair& frames, const PoolHandle&, IntensityChange&, StageTimes&) override {
    if (frames.cur.index == 3) test::failAllAllocations();
  }
};

TEST(FeedMemory, OutOfItAFeedEndsAndTheServerGoesOn) {
  spdlog::set_level(spdlog::level::off);
  Totals totals;
  ClientLog log;
  WakeFd transport;
  TilePool pool(1);
  const FeedConfig config{.camera = pinhole(45, 8, 8), .frame_rate_hz = 100, .params = {}};
  const auto scene = std::make_shared<RenderScene>(test::furnace(0.5f, 1));
  FeedRunner runner(
      std::make_shared<Rig>(std::make_unique<Feed>(scene, Trajectory({{TimeNs(0), Pose{}}}), config,
                                                   std::make_unique<Greedy>(), SeedPlan::independent, pool)),
      FeedPace{5, 0}, pool, totals, log);
  const auto session =
      std::make_shared<Session>("1", v1::DELIVERY_LOSSLESS, 1, transport, runner.notifier(), totals.traffic);
  ResolvedStream stream{.feed = config, .sensors = {{}}, .changes = {{}}};
  stream.request.set_codec(v1::CODEC_NONE);
  stream.request.add_sensors();
  runner.add(std::make_shared<StreamSink>(session, stream, 0));
  session->start();
  EXPECT_TRUE(runner.notifier()->waitUntil(ChangeNotifier::Clock::now() + kPatience,
                                           [&] { return session->finished(); }));
  EXPECT_EQ(runner.progress().frames, 2u);
}

}  // namespace
}  // namespace saccade
