// Streams whose camera the client steers.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "mock/bad_request.h"
#include "mock/control_calls.h"
#include "mock/events_of.h"
#include "mock/wait_until.h"

namespace saccade {
namespace {

// Poses beside the events. Channel 0 is the sensor.
v1::OpenStream lockstep(int frames) {
  v1::OpenStream request = tinyRequest();
  request.mutable_timing()->set_clock(v1::CLOCK_LOCKSTEP);
  request.mutable_timing()->set_duration_s(frames * 0.002);
  request.add_truth()->set_name("pose");
  return request;
}

using Row = std::array<double, 7>;

std::vector<Row> posesOf(const Packets& packets) {
  std::vector<Row> rows;
  for (const TruthSample& sample : samplesOf(packets))
    std::memcpy(rows.emplace_back().data(), sample.elements.data(), sizeof(Row));
  return rows;
}

// But for END, which tells why the stream has ended.
std::string bytesOf(std::map<std::uint32_t, Packets> packets) {
  std::string bytes;
  for (auto& [channel, of_channel] : packets) {
    EXPECT_EQ(of_channel.back().header.kind(), v1::KIND_END);
    of_channel.pop_back();
    bytes += comparableBytes(of_channel);
  }
  return bytes;
}

class Steered : public testing::Test {
 protected:
  v1::StreamOpened open(const v1::OpenStream& request) {
    const v1::StreamOpened stream = server_.client().open(request);
    subscriber_.attach(stream);
    subscriber_.giveCredit(1 << 24);
    return stream;
  }
  v1::Reply call(const v1::Request& request) { return server_.client().call(request); }

  // The next packet of the sensor.
  v1::PacketHeader nextOfSensor() {
    while (true) {
      const auto packet = subscriber_.receive();
      if (!packet) throw std::runtime_error("no packet");
      if (packet->header.sensor() == 0) return packet->header;
    }
  }

  TestServer server_{2};
  MockSubscriber subscriber_ = server_.dataSubscriber();
};

TEST_F(Steered, RendersAFrameForEachPose) {
  const auto stream = open(lockstep(5));
  EXPECT_TRUE(stream.resolved().timing().steerable());
  for (int i = 1; i <= 5; ++i) {
    const v1::Reply reply = call(steerTo(stream, 0.01 * i));
    EXPECT_EQ(reply.steer().frame(), static_cast<std::uint64_t>(i));
    EXPECT_EQ(reply.steer().t_ns(), i * 2'000'000);
    v1::PacketHeader header = nextOfSensor();
    EXPECT_EQ(header.t0_ns(), (i - 1) * 2'000'000);
    if (i == 3) header = nextOfSensor();  // a packet also ends at 5 ms
    EXPECT_EQ(header.t1_ns(), i * 2'000'000);
  }
  EXPECT_EQ(nextOfSensor().end_reason(), v1::END_REASON_FINISHED);
  EXPECT_EQ(call(steerTo(stream, 0)).status().code(), v1::CODE_NOT_FOUND);
}

TEST_F(Steered, HasThePosesExactly) {
  const auto stream = open(lockstep(4));
  for (int i = 1; i <= 4; ++i) call(steerTo(stream, 0.01 * i));
  const std::vector<Row> poses = posesOf(subscriber_.receiveAll(2)[1]);
  ASSERT_EQ(poses.size(), 5u);
  for (int i = 1; i <= 4; ++i) {
    const Row& row = poses[static_cast<std::size_t>(i)];
    EXPECT_EQ(row[0], kCornellX - 0.01 * i);
    EXPECT_EQ(row[2], -7.5);
    EXPECT_EQ(std::abs(row[5]), 1);
  }
}

TEST_F(Steered, GoesOnFromTheLastPoseAtAVelocity) {
  const auto stream = open(lockstep(3));
  call(steerTo(stream, 0));
  call(steerBy(stream, 5, 0));
  call(steerBy(stream, 0, 10));
  const std::vector<Row> poses = posesOf(subscriber_.receiveAll(2)[1]);
  ASSERT_EQ(poses.size(), 4u);
  EXPECT_NEAR(poses[2][0], kCornellX - 5 * 0.002, 1e-12);  // to the right is along the world's -x
  EXPECT_NEAR(poses[3][0], poses[2][0], 1e-12);
  double cosine = 0;
  for (int i = 3; i < 7; ++i) cosine += poses[2][i] * poses[3][i];
  EXPECT_NEAR(2 * std::acos(std::min(1.0, std::abs(cosine))), 10 * 0.002, 1e-7);
}

TEST_F(Steered, IsReplayedByteForByte) {
  const auto stream = open(lockstep(12));
  for (int i = 1; i <= 4; ++i) call(steerTo(stream, 0.003 * i * i));
  for (int i = 5; i <= 12; ++i) call(steerBy(stream, 0.7 * i, 0.3 * (8 - i)));
  auto packets = subscriber_.receiveAll(2);
  EXPECT_GT(checkPackets(packets[0]).events, 100u);
  const v1::OpenStream again = describe(server_.client(), stream);
  EXPECT_EQ(again.timing().clock(), v1::CLOCK_FAST);
  EXPECT_FALSE(again.timing().steerable());
  EXPECT_EQ(again.trajectory().keyframes().keys_size(), 13);
  EXPECT_EQ(bytesOf(packets), bytesOf(server_.run(again)));
}

TEST_F(Steered, IsReplayedUpToWhereItWasClosed) {
  const auto stream = open(lockstep(100));
  for (int i = 1; i <= 7; ++i) call(steerTo(stream, 0.01 * i));
  while (nextOfSensor().t1_ns() < 14'000'000) {
  }
  const v1::OpenStream again = describe(server_.client(), stream);
  EXPECT_EQ(server_.client().close(stream).code(), v1::CODE_OK);
  EXPECT_EQ(nextOfSensor().end_reason(), v1::END_REASON_CLOSED);
  EXPECT_EQ(server_.client().open(again).frames(), 7u);
}

TEST_F(Steered, FollowsItsTrajectoryUntilItIsSteered) {
  v1::OpenStream request = lockstep(2000);
  request.mutable_timing()->set_clock(v1::CLOCK_FAST);
  request.mutable_timing()->set_steerable(true);
  const auto stream = server_.client().open(request);
  const v1::Reply reply = call(steerBy(stream, 0, 0));  // nothing is rendered before the attach
  EXPECT_EQ(reply.steer().frame(), 1u);
  EXPECT_EQ(call(steerTo(stream, 0.2)).steer().frame(), 1u);  // the newest counts
  subscriber_.attach(stream);
  subscriber_.giveCredit(1 << 24);
  while (nextOfSensor().t1_ns() < 10'000'000) {
  }
  const std::uint64_t frame = call(steerTo(stream, 0.1)).steer().frame();
  ASSERT_TRUE(
      waitUntil([&] { return server_.client().info(stream.stream_id()).frames_done() > frame; }, kPatience));
  server_.client().close(stream);
  auto packets = subscriber_.receiveAll(2);
  const v1::OpenStream again = describe(server_.client(), stream);
  const auto& keys = again.trajectory().keyframes().keys();
  for (int i = 1; i < keys.size(); ++i) {
    EXPECT_EQ(keys[i].position().x(),
              static_cast<std::uint64_t>(i) < frame ? kCornellX - 0.2 : kCornellX - 0.1)
        << i;
  }
}

TEST_F(Steered, IsReplayedWithTheTrajectoryItHadBefore) {
  v1::OpenStream request = lockstep(20);
  request.mutable_timing()->set_clock(v1::CLOCK_FAST);
  request.mutable_timing()->set_steerable(true);
  const auto stream = open(request);
  auto packets = subscriber_.receiveAll(2);
  EXPECT_EQ(bytesOf(packets), bytesOf(server_.run(describe(server_.client(), stream))));
  EXPECT_GT(checkPackets(packets[0]).events, 100u);
}

TEST_F(Steered, BoundsThePosesThatWait) {
  Config config = testConfig();
  config.limits[Limit::kSteers] = 3;
  TestServer server(config);
  const auto stream = server.client().open(lockstep(100));
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(server.client().call(steerTo(stream, 0)).status().code(), v1::CODE_OK);
  const v1::Status full = server.client().call(steerTo(stream, 0)).status();
  EXPECT_EQ(full.code(), v1::CODE_RESOURCE_EXHAUSTED);
  EXPECT_EQ(full.limit(), "steers");
  EXPECT_GT(full.retry_after_s(), 0);
}

TEST_F(Steered, BoundsThePathThatIsKept) {
  v1::OpenStream endless = lockstep(5);
  endless.mutable_timing()->set_duration_s(0);
  EXPECT_EQ(server_.client().open(endless).frames(), 99'999u);
  v1::OpenStream longer = lockstep(100'000);
  const v1::Status status = server_.client().tryOpen(longer);
  EXPECT_EQ(status.code(), v1::CODE_RESOURCE_EXHAUSTED);
  EXPECT_EQ(status.field(), "timing.duration_s");
  EXPECT_EQ(status.limit(), "trajectory-points");
}

TEST_F(Steered, RefusesBadCalls) {
  const auto stream = open(lockstep(5)), other = server_.client().open(tinyRequest());
  const auto expect = [&](v1::Request request, v1::Code code, const std::string& field) {
    const v1::Status status = call(request).status();
    EXPECT_EQ(status.code(), code) << status.ShortDebugString();
    EXPECT_EQ(status.field(), field) << status.ShortDebugString();
  };
  v1::Request stranger = steerTo(stream, 0), nowhere = steerTo(stream, 0), far = steerTo(stream, 1e10),
              wild = steerBy(stream, 0, 1e4), aimless, lost = steerTo(stream, 0);
  stranger.mutable_steer()->set_token("0");
  nowhere.mutable_steer()->mutable_pose()->clear_rotation();
  forStream(*aimless.mutable_steer(), stream);
  lost.mutable_steer()->set_stream_id("0");
  expect(stranger, v1::CODE_PERMISSION_DENIED, "token");
  expect(lost, v1::CODE_NOT_FOUND, "stream_id");
  expect(nowhere, v1::CODE_INVALID_ARGUMENT, "pose.rotation");
  expect(far, v1::CODE_INVALID_ARGUMENT, "pose.position.x");
  expect(wild, v1::CODE_INVALID_ARGUMENT, "velocity.angular.y");
  expect(aimless, v1::CODE_INVALID_ARGUMENT, "target");
  expect(steerTo(other, 0), v1::CODE_INVALID_ARGUMENT, "stream_id");
}

TEST_F(Steered, RefusesWhatAnUnknownPathCannotHave) {
  using Open = v1::OpenStream;
  expectRefused(server_, {{lockstep(5), [](Open& r) { r.mutable_sensors(0)->set_from_event(1); },
                           v1::CODE_INVALID_ARGUMENT, "sensors[0].from_event", "steered"},
                          {lockstep(5),
                           [](Open& r) {
                             r.mutable_method()->set_name("irradiance_cache");
                             r.mutable_quality()->set_bake_error(0.1);
                           },
                           v1::CODE_INVALID_ARGUMENT, "quality.bake_error", "path"}});
}

TEST_F(Steered, TellsThatItLivesWhileItWaits) {
  open(lockstep(5));
  const auto packet = subscriber_.receiveAny();
  ASSERT_TRUE(packet);
  EXPECT_EQ(packet->header.kind(), v1::KIND_HEARTBEAT);
}

TEST_F(Steered, EndsWhileItWaits) {
  const auto stream = open(lockstep(5));
  call(steerTo(stream, 0.1));
  EXPECT_EQ(nextOfSensor().kind(), v1::KIND_EVENTS);
  server_.client().close(stream);
  EXPECT_EQ(nextOfSensor().end_reason(), v1::END_REASON_CLOSED);
}

TEST_F(Steered, EndsWithItsServerWhileItWaits) {
  auto server = std::make_unique<TestServer>();
  const auto stream = server->client().open(lockstep(5));
  MockSubscriber subscriber = server->dataSubscriber();
  subscriber.attach(stream);
  subscriber.giveCredit(1 << 20);
  ASSERT_TRUE(subscriber.receiveAny());  // a heartbeat: it is attached
  server.reset();
  EXPECT_EQ(subscriber.receive()->header.end_reason(), v1::END_REASON_DRAINING);
}

TEST_F(Steered, IsAbandonedWithItsClient) {
  Config config = testConfig();
  config.lease_s = 0.2;
  TestServer server(config);
  const auto stream = server.client().open(lockstep(5));
  EXPECT_TRUE(
      waitUntil([&] { return server.client().info(stream.stream_id()).stream_id().empty(); }, kPatience));
}

TEST_F(Steered, HasAFeedOfItsOwn) {
  v1::OpenStream request = lockstep(5);
  request.mutable_timing()->set_clock(v1::CLOCK_PACED);
  request.mutable_timing()->set_steerable(true);
  request.set_delivery(v1::DELIVERY_LIVE);
  const auto one = server_.client().open(request), two = server_.client().open(request);
  call(steerTo(one, 0.5));
  EXPECT_EQ(describe(server_.client(), two).trajectory().keyframes().keys_size(), 1);
  subscriber_.attach(one);
  subscriber_.giveCredit(1 << 24);
  subscriber_.receiveAll(2);
  EXPECT_EQ(describe(server_.client(), one).trajectory().keyframes().keys(1).position().x(), kCornellX - 0.5);
  EXPECT_EQ(describe(server_.client(), two).trajectory().keyframes().keys_size(), 1);
}

}  // namespace
}  // namespace saccade
