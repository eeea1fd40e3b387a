// The end of streams that nobody looks after, with a clock that the test moves.
#include "app/streams/stream_registry.h"

#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include "app/request/refusal.h"
#include "feed/rig.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

class StreamRegistryTest : public testing::Test {
 protected:
  StreamRegistryTest() { spdlog::set_level(spdlog::level::warn); }

  std::shared_ptr<Session> add(const std::string& id, v1::Delivery delivery, const std::string& user = {}) {
    Stream stream;
    stream.user = user;
    stream.session =
        std::make_shared<Session>(id, delivery, 1, transport_, std::make_shared<ChangeNotifier>(), traffic_);
    streams_.add(stream);
    return stream.session;
  }
  ChangeNotifier::Clock::time_point later(int seconds) const {
    return ChangeNotifier::Clock::now() + std::chrono::seconds(seconds);
  }

  WakeFd transport_;
  SessionDirectory sessions_;
  Traffic traffic_;
  ClientLog log_;
  StreamRegistry streams_{sessions_, log_, std::chrono::seconds(30)};
};

TEST_F(StreamRegistryTest, EndsAndThenForgetsAStreamWithoutReceiver) {
  const auto session = add("1", v1::DELIVERY_LOSSLESS);
  streams_.sweep(later(29));
  EXPECT_FALSE(session->stopping());
  streams_.sweep(later(31));
  EXPECT_TRUE(session->stopping());
  EXPECT_TRUE(sessions_.find("1"));  // its producer has not ended it yet
  session->finish();
  streams_.sweep(later(29));
  EXPECT_TRUE(sessions_.find("1"));
  streams_.sweep(later(31));
  EXPECT_FALSE(sessions_.find("1"));
}

// However short the lease is beside the time between two heartbeats.
TEST_F(StreamRegistryTest, KeepsAStreamWhoseReceiverIsThereThoughItTakesNothing) {
  const auto session = add("1", v1::DELIVERY_LOSSLESS);
  session->start();
  streams_.sweep(later(3600));
  EXPECT_FALSE(session->stopping());
  session->leave();
  streams_.sweep(later(29));
  EXPECT_FALSE(session->stopping());
  streams_.sweep(later(31));
  EXPECT_TRUE(session->stopping());
  session->finish();
  streams_.sweep(later(31));
  EXPECT_FALSE(sessions_.find("1"));
}

// It sends all the same, but that is nobody's sign of life.
TEST_F(StreamRegistryTest, EndsABroadcastWithoutSubscribers) {
  const auto session = add("1", v1::DELIVERY_BROADCAST);
  session->start();
  session->leave();
  session->push(makeErrorPacket("1", "to nobody"));
  const auto before = session->unattended();
  EXPECT_TRUE(session->sendOldest([](const WirePacket&) { return true; }));
  EXPECT_EQ(session->unattended(), before);
  streams_.sweep(later(31));
  EXPECT_TRUE(session->stopping());
  EXPECT_EQ(session->endReason(), v1::END_REASON_ABANDONED);
  session->finish();
  streams_.sweep(later(31));
  EXPECT_FALSE(sessions_.find("1"));
}

TEST_F(StreamRegistryTest, ForgetsAClosedStreamOnceItsPacketsAreTaken) {
  const auto session = add("1", v1::DELIVERY_LOSSLESS);
  session->start();
  EXPECT_THROW(streams_.close("1", "not the token", {}), Refusal);
  EXPECT_FALSE(session->stopping());
  streams_.close("1", session->token(), {});
  EXPECT_TRUE(session->stopping());
  session->push(makeErrorPacket("1", "the last"));
  session->finish();
  streams_.sweep(later(0));
  EXPECT_TRUE(sessions_.find("1"));
  EXPECT_TRUE(session->sendOldest([](const WirePacket&) { return true; }));
  streams_.sweep(later(0));
  EXPECT_FALSE(sessions_.find("1"));
  EXPECT_THROW(streams_.close("1", session->token(), {}), Refusal);
}

TEST_F(StreamRegistryTest, ClosesWithoutATokenForItsOwnerAndForAnAdmin) {
  add("1", v1::DELIVERY_LOSSLESS, "alice");
  add("2", v1::DELIVERY_LOSSLESS, "alice");
  const auto keyless = add("3", v1::DELIVERY_LOSSLESS);
  EXPECT_THROW(streams_.close("1", "", {"c", "bob"}), Refusal);
  EXPECT_THROW(streams_.close("3", "", {"c", ""}), Refusal);
  EXPECT_THROW(streams_.close("1", "not the token", {"c", "bob", true}), Refusal);
  EXPECT_FALSE(keyless->stopping());
  streams_.close("1", "", {"c", "alice"});
  streams_.close("2", "", {"c", "bob", true});
  streams_.close("3", "", {"c", "", true});
  EXPECT_TRUE(keyless->stopping());
  streams_.sweep(later(0));
  EXPECT_FALSE(sessions_.find("1") || sessions_.find("2") || sessions_.find("3"));
}

// As by one who has only asked what a stream would be like.
TEST_F(StreamRegistryTest, ForgetsAtOnceWhatNobodyHasReceivedWhenItIsClosed) {
  const auto session = add("1", v1::DELIVERY_LOSSLESS);
  streams_.close("1", session->token(), {});
  streams_.sweep(later(0));  // its producer has not ended it yet
  EXPECT_FALSE(sessions_.find("1"));
}

// A request may have tens of MiB, and each get_frame and describe_stream asks for its stream.
TEST_F(StreamRegistryTest, ACopyOfAnEntrySharesItsRequest) {
  Stream stream;
  stream.request = std::make_shared<const v1::OpenStream>();
  stream.session = std::make_shared<Session>("1", v1::DELIVERY_LOSSLESS, 1, transport_,
                                             std::make_shared<ChangeNotifier>(), traffic_);
  streams_.add(stream);
  EXPECT_EQ(streams_.find("1", stream.session->token()).request, stream.request);
  stream.session->finish();
  streams_.sweep(later(31));  // it has no feed that the end of the registry could wait for
}

// Two streams at one feed, and one at another. Each has its own sensors.
TEST_F(StreamRegistryTest, AFeedThatIsSharedIsALoadOnce) {
  TilePool pool(1);
  Totals totals;
  const auto feed = [&] {
    FeedConfig config{.camera = pinhole(45, 8, 8), .frame_rate_hz = 100, .params = {}};
    std::string none;
    EXPECT_EQ(resolveParams(*findMethod(config.method), {}, config.params, none), "");
    return std::make_shared<FeedRunner>(std::make_shared<Rig>(std::make_unique<Feed>(
                                            std::make_shared<const RenderScene>(test::furnace(0.5f, 1)),
                                            Trajectory({{TimeNs(0), Pose{}}}), config, pool)),
                                        FeedPace{5, 2}, pool, totals, log_);
  };
  Stream stream;
  v1::OpenStream request;
  request.mutable_timing()->set_clock(v1::CLOCK_PACED);
  request.mutable_timing()->set_frame_rate_hz(100);
  request.mutable_timing()->set_speed(2);
  stream.request = std::make_shared<const v1::OpenStream>(request);
  stream.frame_cost = {1e-3, 1e-4, 5e-4, 1e-4};
  const auto shared = feed(), own = feed();
  std::vector<std::shared_ptr<Session>> sessions;
  for (const auto& [id, looked_at] : {std::pair("1", shared), {"2", shared}, {"3", own}}) {
    stream.feed = looked_at;
    stream.session = std::make_shared<Session>(id, v1::DELIVERY_LIVE, 1, transport_,
                                               std::make_shared<ChangeNotifier>(), traffic_);
    stream.sink = std::make_shared<StreamSink>(stream.session, ResolvedStream{}, 0);
    sessions.push_back(stream.session);
    streams_.add(stream);
  }
  EXPECT_DOUBLE_EQ(streams_.load(nullptr).total, 2 * 0.2 + 3 * 0.02);
  EXPECT_EQ(streams_.load(nullptr).feed.sensors, 0);
  const CpuCost both = streams_.load(shared.get()).feed;
  EXPECT_DOUBLE_EQ(both.feed, 0.2);
  EXPECT_DOUBLE_EQ(both.sensors, 2 * 0.02);
  EXPECT_DOUBLE_EQ(both.critical_path, 0.1);
  EXPECT_DOUBLE_EQ(both.longest, 0.02);
  sessions[0]->finish();
  EXPECT_DOUBLE_EQ(streams_.load(nullptr).total, 2 * 0.2 + 2 * 0.02);
  sessions[1]->finish();
  EXPECT_DOUBLE_EQ(streams_.load(nullptr).total, 0.2 + 0.02);
}

}  // namespace
}  // namespace saccade
