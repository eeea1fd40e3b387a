// A feed that fails, or that nobody wants any more amid a frame, is the matter of its own streams.
#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <sstream>
#include <stdexcept>

#include "app/feeds/feed_runner.h"
#include "feed/rig.h"
#include "mock/mock_client.h"
#include "mock/wait_until.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

// Sees no change, and fails at one frame: on the pool's threads, where most of the work is done.
class FailingMethod : public Method {
 public:
  explicit FailingMethod(FrameIndex fails_at) : fails_at_(fails_at) {}
  void start(const Frame&, const PoolHandle&) override {}
  void estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange&, StageTimes&) override {
    if (frames.cur.index != fails_at_) return;
    pool.run(4, [](int) { throw std::runtime_error("out of luck"); });
  }

 private:
  const FrameIndex fails_at_;
};

// Has a second frame that takes for ever.
class EndlessMethod : public Method {
 public:
  explicit EndlessMethod(std::atomic<bool>& reached) : reached_(reached) {}
  void start(const Frame&, const PoolHandle&) override {}
  void estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange&, StageTimes&) override {
    if (frames.cur.index < 2) return;
    reached_ = true;
    while (true) pool.run(1, [](int) {});
  }

 private:
  std::atomic<bool>& reached_;
};

class FeedFailure : public testing::Test {
 protected:
  static constexpr FrameIndex kFrames = 5;
  static constexpr std::size_t kPacketsPerFrame = 2;  // of 10 ms
  FeedFailure() { spdlog::set_level(spdlog::level::off); }

  std::unique_ptr<FeedRunner> runner(FrameIndex fails_at) {
    return runner(std::make_unique<FailingMethod>(fails_at));
  }
  std::unique_ptr<FeedRunner> runner(std::unique_ptr<Method> method) {
    const FeedConfig config{.camera = pinhole(45, 8, 8), .frame_rate_hz = 100, .params = {}};
    auto feed = std::make_unique<Feed>(scene_, Trajectory({{TimeNs(0), Pose{}}}), config, std::move(method),
                                       SeedPlan::independent, pool_);
    return std::make_unique<FeedRunner>(std::make_shared<Rig>(std::move(feed)), FeedPace{kFrames, 0}, pool_,
                                        totals_, log_);
  }

  static std::shared_ptr<StreamSink> makeSink(const std::shared_ptr<Session>& session) {
    ResolvedStream stream{.feed = {.camera = pinhole(45, 8, 8), .params = {}}};
    stream.request.set_codec(v1::CODEC_NONE);
    for (std::uint32_t i = 0; i < session->channels(); ++i) stream.request.add_sensors();
    stream.sensors.resize(session->channels());
    stream.changes.resize(session->channels());
    return std::make_shared<StreamSink>(session, stream, 0);
  }

  // Of a stream with two sensors, from its start to its end.
  std::vector<v1::PacketHeader> packetsOf(FeedRunner& runner) {
    const auto session = std::make_shared<Session>("1", v1::DELIVERY_LOSSLESS, 2, transport_,
                                                   runner.notifier(), totals_.traffic);
    runner.add(makeSink(session));
    session->start();
    EXPECT_TRUE(runner.notifier()->waitUntil(ChangeNotifier::Clock::now() + kPatience,
                                             [&] { return session->finished(); }));
    std::vector<v1::PacketHeader> headers;
    while (session->sendOldest([&](const WirePacket& packet) {
      last_payload_ = *packet.payload;
      return headers.emplace_back().ParseFromString(packet.header);
    })) {
    }
    return headers;
  }

  Totals totals_;
  ClientLog log_;
  TilePool pool_{2};
  WakeFd transport_;
  std::string last_payload_;
  std::shared_ptr<const RenderScene> scene_ = std::make_shared<RenderScene>(test::furnace(0.5f, 1));
};

TEST_F(FeedFailure, EndsItsStreamsWithErrorAndNoOthers) {
  const auto failing = runner(3), healthy = runner(kFrames + 1);
  const auto cut_short = packetsOf(*failing);
  ASSERT_EQ(cut_short.size(), 2u * kPacketsPerFrame * 2 + 2);  // frames 1 and 2
  for (std::uint32_t sensor : {0u, 1u}) {
    const v1::PacketHeader& last = cut_short[cut_short.size() - 2 + sensor];
    EXPECT_EQ(last.kind(), v1::KIND_ERROR);
    EXPECT_EQ(last.sensor(), sensor);
  }
  EXPECT_NE(last_payload_.find("out of luck"), std::string::npos);

  const auto whole = packetsOf(*healthy);
  ASSERT_EQ(whole.size(), 2u * kPacketsPerFrame * kFrames + 2);
  EXPECT_EQ(whole.back().kind(), v1::KIND_END);
}

// The END comes where the last whole frame ended.
TEST_F(FeedFailure, AFrameThatNobodyWantsIsNotFinished) {
  std::atomic<bool> reached = false;
  const auto endless = runner(std::make_unique<EndlessMethod>(reached));
  std::vector<std::shared_ptr<Session>> sessions;
  for (const char* id : {"1", "2"}) {
    sessions.push_back(std::make_shared<Session>(id, v1::DELIVERY_LOSSLESS, 1, transport_,
                                                 endless->notifier(), totals_.traffic));
    endless->add(makeSink(sessions.back()));
  }
  for (const auto& session : sessions) session->start();
  ASSERT_TRUE(waitUntil([&] { return reached.load(); }, kPatience));
  sessions[0]->stop(v1::END_REASON_CLOSED);
  endless->interrupt();
  EXPECT_FALSE(endless->notifier()->waitUntil(ChangeNotifier::Clock::now() + std::chrono::milliseconds(100),
                                              [&] { return sessions[0]->finished(); }))
      << "the other stream still wants the frame";
  sessions[1]->stop(v1::END_REASON_CLOSED);
  endless->interrupt();
  for (const auto& session : sessions) {
    EXPECT_TRUE(endless->notifier()->waitUntil(ChangeNotifier::Clock::now() + kPatience,
                                               [&] { return session->finished(); }));
    v1::PacketHeader last;
    while (
        session->sendOldest([&](const WirePacket& packet) { return last.ParseFromString(packet.header); })) {
    }
    EXPECT_EQ(last.kind(), v1::KIND_END);
    EXPECT_EQ(last.t1_ns(), 10'000'000);
  }
}

// Intervals of nothing. Calls `on_second` when it has made the second one.
class QuietSource : public IntervalSource {
 public:
  explicit QuietSource(std::function<void()> on_second) : on_second_(std::move(on_second)) {}
  const std::vector<FeedInterval>& step(const PoolHandle&) override {
    IntensityChange& change = changes_[++frame_ % 2];
    change.frame = frame_;
    change.t0 = frameTime(frame_ - 1, 100), change.t1 = frameTime(frame_, 100);
    for (ImageF* plane : {&change.I_prev, &change.I_now}) plane->fill(1);
    intervals_.clear();
    intervals_.push_back({change, {}});
    if (frame_ == 2) on_second_();
    return intervals_;
  }
  StageTimes lastTimes() const override { return {}; }
  std::chrono::nanoseconds lastCriticalPath() const override { return {}; }

 private:
  const std::function<void()> on_second_;
  std::array<IntensityChange, 2> changes_{IntensityChange(8, 8), IntensityChange(8, 8)};
  FrameIndex frame_ = 0;
  std::vector<FeedInterval> intervals_;
};

// Their work may take longer than that of the renderer. Each sensor ends where it has got.
TEST_F(FeedFailure, AFrameThatNobodyWantsIsNotFinishedBySensors) {
  constexpr std::uint32_t kSensors = 32;
  std::unique_ptr<FeedRunner> runner;
  std::shared_ptr<Session> session;
  runner = std::make_unique<FeedRunner>(std::make_shared<QuietSource>([&] {
                                          session->stop(v1::END_REASON_CLOSED);
                                          runner->interrupt();
                                        }),
                                        FeedPace{0, 0}, pool_, totals_, log_);
  session = std::make_shared<Session>("1", v1::DELIVERY_LOSSLESS, kSensors, transport_, runner->notifier(),
                                      totals_.traffic);
  runner->add(makeSink(session));
  session->start();
  ASSERT_TRUE(runner->notifier()->waitUntil(ChangeNotifier::Clock::now() + kPatience,
                                            [&] { return session->finished(); }));
  std::map<std::uint32_t, v1::PacketHeader> last;
  while (session->sendOldest([&](const WirePacket& packet) {
    v1::PacketHeader header;
    EXPECT_TRUE(header.ParseFromString(packet.header));
    EXPECT_EQ(header.t0_ns(), last[header.sensor()].t1_ns());
    last[header.sensor()] = header;
    return true;
  })) {
  }
  int whole = 0;
  for (const auto& [sensor, header] : last) {
    EXPECT_EQ(header.kind(), v1::KIND_END);
    EXPECT_TRUE(header.t0_ns() == 10'000'000 || header.t0_ns() == 20'000'000) << header.t0_ns();
    whole += header.t0_ns() == 20'000'000;
  }
  EXPECT_EQ(last.size(), kSensors);
  EXPECT_LE(whole, pool_.threads());  // what was under way
}

// A client may open and close streams as fast as it likes.
TEST_F(FeedFailure, TheEndsOfStreamsDoNotFillTheLog) {
  std::ostringstream text;
  const auto before = spdlog::default_logger();
  spdlog::set_default_logger(
      std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_mt>(text)));
  const auto began = LogLimit::Clock::now();
  for (int i = 0; i < 3 * LogLimit::kBurst; ++i) packetsOf(*runner(1));  // which logs a fault, too
  for (int i = 0; i < 3 * LogLimit::kBurst; ++i) packetsOf(*runner(kFrames + 1));
  const auto pauses = (LogLimit::Clock::now() - began) / LogLimit::kPause;
  spdlog::set_default_logger(before);
  const std::string lines = text.str();
  EXPECT_LE(std::count(lines.begin(), lines.end(), '\n'), LogLimit::kBurst + 2 * (pauses + 1));
}

TEST_F(FeedFailure, LetsNobodyJoinAfterwards) {
  const auto failing = runner(1);
  packetsOf(*failing);
  const auto late =
      std::make_shared<Session>("2", v1::DELIVERY_LIVE, 1, transport_, failing->notifier(), totals_.traffic);
  EXPECT_FALSE(failing->add(makeSink(late)));
}

}  // namespace
}  // namespace saccade
