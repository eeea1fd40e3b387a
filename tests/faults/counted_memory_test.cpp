// Requests that are small, and make much: what they make is counted by a limit before it is made.
#include <gtest/gtest.h>

#include "mock/control_calls.h"
#include "mock/server_process.h"
#include "mock/test_server.h"
#include "mock/wait_until.h"
#include "mock/zmtp_peer.h"

namespace saccade {
namespace {

constexpr double kMiB = 1 << 20;
constexpr double kMemoryMiB = 160, kQueuesMiB = 64, kOtherMiB = 24;  // other: as in full_server_test.cpp

class CountedMemory : public testing::Test {
 protected:
  void SetUp() override {
    if (kSanitized) GTEST_SKIP() << "sanitizers keep what is freed";
    client_.close(client_.open(tinyRequest()));  // the scene is loaded, and all threads have run
    before_ = server_.usage().resident_bytes;
  }
  double grownMiB() const { return static_cast<double>(server_.usage().resident_bytes - before_) / kMiB; }

  // Opens streams until a limit is reached, and lets each make a frame. Returns the limit.
  std::string fill(v1::OpenStream request) {
    while (true) {
      v1::Request open;
      request.set_seed(streams_.size());
      *open.mutable_open_stream() = request;
      const v1::Reply reply = client_.call(open);
      if (reply.status().code() != v1::CODE_OK) return reply.status().limit();
      streams_.push_back(reply.open_stream());
      subscribers_.push_back(std::make_unique<MockSubscriber>(server_.data()));
      subscribers_.back()->attach(streams_.back());
    }
  }
  void awaitFrames(std::uint64_t frames = 1) {
    for (const auto& stream : streams_)
      ASSERT_TRUE(
          waitUntil([&] { return client_.info(stream.stream_id()).frames_done() >= frames; }, kPatience));
  }

  ServerProcess server_{{"--limit-memory", std::to_string(kMemoryMiB), "--limit-queues",
                         std::to_string(kQueuesMiB), "--limit-queue", "0.5"}};
  MockClient client_{server_.control()};
  std::int64_t before_ = 0;
  std::vector<v1::StreamOpened> streams_;
  std::vector<std::unique_ptr<MockSubscriber>> subscribers_;
};

TEST_F(CountedMemory, RowsOfAFrame) {
  v1::OpenStream request = tinyRequest();
  request.mutable_view()->set_width(1);
  request.mutable_view()->set_height(1);
  request.mutable_quality()->set_bounces(0);
  request.mutable_timing()->set_frame_rate_hz(0.1);
  request.mutable_timing()->set_duration_s(0);
  request.add_truth()->set_name("imu");
  request.mutable_truth(0)->mutable_imu()->set_rate_hz(1e4);  // 100000 in a frame
  EXPECT_EQ(fill(request), "memory");
  EXPECT_GE(streams_.size(), 2u);
  awaitFrames();
  EXPECT_LT(grownMiB(), kMemoryMiB + kQueuesMiB + kOtherMiB);
}

// Two bodies, the lamp and the camera; the sensor has no event to send.
TEST_F(CountedMemory, ObjectsThatMove) {
  v1::OpenStream request = tinyRequest();
  request.set_scene("cornell-turntable");
  request.mutable_view()->set_width(64);
  request.mutable_view()->set_height(48);
  request.mutable_timing()->set_frame_rate_hz(50);
  request.mutable_timing()->set_duration_s(0);
  request.mutable_sensors(0)->set_threshold(5);
  v1::ObjectMotion& lamp = *request.add_objects();
  lamp.set_name("light");
  lamp.mutable_path()->mutable_motion()->set_kind(v1::OBJECT_MOTION_KIND_SLIDE);
  lamp.mutable_path()->mutable_motion()->set_speed(0.3);
  EXPECT_EQ(fill(request), "memory");
  EXPECT_GE(streams_.size(), 3u);
  awaitFrames(20);
  EXPECT_LT(grownMiB(), kMemoryMiB + kOtherMiB);
}

// Updates of nearly all pixels, in intervals of a pixel and more; the sensor has no event to send.
v1::OpenStream refined(const std::string& scene) {
  v1::OpenStream request = tinyRequest();
  request.set_scene(scene);
  request.mutable_view()->set_width(48);
  request.mutable_view()->set_height(36);
  v1::Motion& motion = *request.mutable_trajectory()->mutable_motion();
  motion.set_kind(v1::MOTION_KIND_PAN);
  motion.set_speed(90);
  v1::Timing& timing = *request.mutable_timing();
  timing.clear_frame_rate_hz();
  timing.set_duration_s(0);
  timing.mutable_refinement()->set_threshold(1e-3);
  request.mutable_sensors(0)->set_threshold(5);
  return request;
}

TEST_F(CountedMemory, RefinedStreams) {
  EXPECT_EQ(fill(refined("textured-cornell-box")), "memory");
  EXPECT_GE(streams_.size(), 2u);
  awaitFrames(10);
  EXPECT_LT(grownMiB(), kMemoryMiB + kOtherMiB);
}

TEST_F(CountedMemory, RefinedStreamsWithObjectsThatMove) {
  EXPECT_EQ(fill(refined("cornell-turntable")), "memory");
  EXPECT_GE(streams_.size(), 2u);
  awaitFrames(10);
  EXPECT_LT(grownMiB(), kMemoryMiB + kOtherMiB);
}

// 64000 changes, each with all of its noise: 15 bytes of a change become 500.
v1::OpenStream manyChanges() {
  v1::OpenStream request;
  request.set_pushed(true);
  request.mutable_view()->set_width(1);
  request.mutable_view()->set_height(1);
  request.mutable_timing()->set_frame_rate_hz(10);
  for (int i = 0; i < 64; ++i) {
    v1::Sensor& sensor = *request.add_sensors();
    for (int k = 0; k < 1000; ++k) {
      v1::SensorChange& change = *sensor.add_changes();
      change.set_time_s(1);
      change.mutable_noise();
    }
  }
  return request;
}

TEST_F(CountedMemory, ChangesOfSensors) {
  EXPECT_EQ(fill(manyChanges()), "memory");
  EXPECT_GE(streams_.size(), 1u);
  EXPECT_LT(grownMiB(), kMemoryMiB + kOtherMiB);
}

// Only the first of them has room for its reply, which nobody reads.
TEST_F(CountedMemory, DescriptionsThatNobodyReads) {
  const v1::StreamOpened stream = client_.open(manyChanges());
  const double opened = grownMiB();
  v1::Request describe;
  describe.set_protocol_version(1);
  forStream(*describe.mutable_describe_stream(), stream);
  std::string many;
  for (int i = 0; i < 500; ++i) many += zmtp::part(describe.SerializeAsString());
  ZmtpPeer peer(server_.control());
  peer.say(many);
  double top = 0;
  for (int i = 0; i < 50; ++i) {
    client_.server();
    top = std::max(top, grownMiB());
  }
  EXPECT_LT(top - opened, 48);  // of 8 MB each: one made, one sent, one in the making
}

// The receiver takes nothing, and the frames come on.
TEST_F(CountedMemory, TruthOfALiveStreamWithoutCredit) {
  constexpr int kChannels = 8, kFrames = 200;
  v1::OpenStream request;
  request.set_pushed(true);
  request.mutable_view()->set_width(256);
  request.mutable_view()->set_height(256);
  request.mutable_timing()->set_frame_rate_hz(100);
  request.add_sensors();
  request.set_delivery(v1::DELIVERY_LIVE);
  for (int i = 0; i < kChannels; ++i) request.add_truth()->set_name("intensity");  // 2 MiB in each frame
  const v1::StreamOpened stream = client_.open(request);
  MockSubscriber subscriber(server_.data());
  subscriber.attach(stream);
  v1::Request push;
  forStream(*push.mutable_push_frame(), stream).set_intensity(std::string(256 * 256 * sizeof(float), '\0'));
  for (int frame = 0; frame < kFrames; ++frame) {
    ASSERT_TRUE(waitUntil([&] { return client_.call(push).status().code() == v1::CODE_OK; }, kPatience));
  }
  EXPECT_LT(grownMiB(), kMemoryMiB + kQueuesMiB + kOtherMiB);
  EXPECT_GT(client_.info(stream.stream_id()).dropped_packets(),
            static_cast<unsigned>((kFrames - 10) * kChannels));
}

}  // namespace
}  // namespace saccade
