#include "app/feeds/stream_sink.h"

#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include "app/interval_of.h"
#include "stream/wake_fd.h"

namespace saccade {
namespace {

// Two sensors; the second has twice the threshold.
ResolvedStream twoSensors() {
  ResolvedStream stream{.request = {},
                        .feed = {.camera = pinhole(45, kWidth, kHeight), .params = {}},
                        .sensors = {{.reconstruction = "direct"}, {.reconstruction = "direct"}},
                        .changes = {{}, {}},
                        .truth = {},
                        .disabled_features = {},
                        .expected = {},
                        .simplification = {}};
  stream.sensors[1].threshold = stream.sensors[1].threshold_off = 0.4;
  for (int i = 0; i < 2; ++i) stream.request.add_sensors();
  stream.request.set_codec(v1::CODEC_NONE);
  return stream;
}

class Sink : public testing::Test {
 protected:
  void publish(FrameIndex frame, std::chrono::milliseconds lag = {}) {
    publish(intervalOf(frame, 1, 0.5f), lag);
  }
  void publish(std::unique_ptr<IntensityChange> change, std::chrono::milliseconds lag = {}) {
    const StillView view(std::move(change));
    for (std::size_t i = 0; i < sink_.channels(); ++i) sink_.process(i, view.interval());
    sink_.publish(view.interval(), lag);
  }
  // The packets that wait for the client.
  std::vector<v1::PacketHeader> sent() {
    std::vector<v1::PacketHeader> headers;
    const auto take = [&](const WirePacket& packet) {
      return headers.emplace_back().ParseFromString(packet.header);
    };
    while (session_->sendOldest(take)) {
    }
    return headers;
  }

  WakeFd transport_;
  Traffic traffic_;
  const std::shared_ptr<Session> session_ =
      std::make_shared<Session>("s", v1::DELIVERY_LOSSLESS, 2, transport_, std::make_shared<ChangeNotifier>(),
                                traffic_, kQueueBytes, 5);
  StreamSink sink_{session_, twoSensors(), 5};
};

TEST_F(Sink, GivesThePacketsOfAllSensorsToTheSession) {
  publish(1);
  const auto headers = sent();
  ASSERT_EQ(headers.size(), 2u);
  for (std::uint32_t i = 0; i < 2; ++i) {
    EXPECT_EQ(headers[i].sensor(), i);
    EXPECT_EQ(headers[i].stream_id(), "s");
    EXPECT_EQ(headers[i].epoch(), 5u);
    EXPECT_EQ(headers[i].t1_ns(), kPacketTimeNs);
  }
  EXPECT_GT(headers[0].count(), headers[1].count());
  EXPECT_EQ(sink_.events(), headers[0].count() + headers[1].count());
  EXPECT_GT(sink_.recentSeconds(), 0);
  EXPECT_LE(sink_.recentLongestSeconds(), sink_.recentSeconds());
}

TEST_F(Sink, TellsTheLagUntilItIsCleared) {
  publish(1, std::chrono::milliseconds(1500));
  for (const auto& header : sent()) EXPECT_EQ(header.lag_ms(), 1500u);
  EXPECT_EQ(session_->heartbeat().header.lag_ms(), 1500u);
  sink_.clearLag();
  EXPECT_EQ(session_->heartbeat().header.lag_ms(), 0u);
}

TEST_F(Sink, EndsEverySensor) {
  session_->stop(v1::END_REASON_CLOSED);
  sink_.end(TimeNs(kPacketTimeNs), 1);
  const auto headers = sent();
  ASSERT_EQ(headers.size(), 2u);
  for (std::uint32_t i = 0; i < 2; ++i) {
    EXPECT_EQ(headers[i].sensor(), i);
    EXPECT_EQ(headers[i].kind(), v1::KIND_END);
    EXPECT_EQ(headers[i].end_reason(), v1::END_REASON_CLOSED);
  }
  EXPECT_TRUE(session_->finished());
}

// As where all streams of a feed are closed in the midst of a frame.
TEST_F(Sink, EndsEachSensorWhereItHasGot) {
  publish(1);
  EXPECT_EQ(sent().size(), 2u);
  const std::uint64_t before = sink_.events();
  const StillView view(intervalOf(2, 1, 0.5f));
  sink_.process(0, view.interval());
  session_->stop(v1::END_REASON_CLOSED);
  sink_.end(TimeNs(2 * kPacketTimeNs), 2);
  const auto headers = sent();
  ASSERT_EQ(headers.size(), 3u);
  EXPECT_EQ(headers[0].kind(), v1::KIND_EVENTS);
  EXPECT_EQ(sink_.events(), before + headers[0].count());
  for (std::uint32_t i = 0; i < 2; ++i) {
    EXPECT_EQ(headers[1 + i].kind(), v1::KIND_END);
    EXPECT_EQ(headers[1 + i].sensor(), i);
    EXPECT_EQ(headers[1 + i].t0_ns(), (2 - i) * kPacketTimeNs);
    EXPECT_EQ(headers[1 + i].seq(), 2u - i);
  }
}

TEST_F(Sink, OfAFeedThatFailsSendsWhatIsLeftAndAnErrorForEverySensor) {
  auto change = intervalOf(1, 1, 0.5f);
  change->t1 = std::chrono::milliseconds(2);  // fills no packet
  publish(std::move(change));
  EXPECT_TRUE(sent().empty());
  sink_.fail("out of luck");
  const auto headers = sent();
  ASSERT_EQ(headers.size(), 4u);
  for (std::uint32_t i = 0; i < 4; ++i) {
    EXPECT_EQ(headers[i].sensor(), i / 2);
    EXPECT_EQ(headers[i].kind(), i % 2 ? v1::KIND_ERROR : v1::KIND_EVENTS);
  }
  EXPECT_TRUE(session_->finished());
}

}  // namespace
}  // namespace saccade
