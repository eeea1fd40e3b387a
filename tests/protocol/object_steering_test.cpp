// Streams whose objects the client steers.
#include <gtest/gtest.h>

#include <cstring>

#include "mock/control_calls.h"
#include "mock/events_of.h"
#include "objects.h"

namespace saccade {
namespace {

constexpr Vec3d kBegin{3.7, 1.7, 3.5};

// The tall block stands until it is steered; the short one spins. Channel 1 has the poses of both.
v1::OpenStream lockstep(int frames) {
  v1::OpenStream request = stillRequest();
  request.mutable_timing()->set_clock(v1::CLOCK_LOCKSTEP);
  request.mutable_timing()->set_duration_s(frames * 0.002);
  addMotion(request, "short_block", v1::OBJECT_MOTION_KIND_SPIN, 90);
  addObject(request, "tall_block").mutable_still();
  request.add_truth()->set_name("object_poses");
  return request;
}

void setPose(Vec3d at, v1::CameraPose& pose) {
  pose.mutable_position()->set_x(at.x), pose.mutable_position()->set_y(at.y);
  pose.mutable_position()->set_z(at.z);
  pose.mutable_rotation()->set_w(2);  // not of unit length
}

v1::Request move(const v1::StreamOpened& stream, const std::string& name, Vec3d at) {
  v1::Request request;
  v1::SteeredObject& object = *forStream(*request.mutable_steer(), stream).add_objects();
  object.set_name(name);
  setPose(at, *object.mutable_pose());
  return request;
}

struct Row {
  double object, x, y, z, qx, qy, qz, qw;
};

// Of the object in `place` of the two, at each frame.
std::vector<Row> rowsOf(const Packets& packets, std::size_t place) {
  std::vector<Row> rows;
  const TruthSamples samples = samplesOf(packets);
  for (std::size_t i = place; i < samples.size(); i += 2)
    std::memcpy(&rows.emplace_back(), samples[i].elements.data(), sizeof(Row));
  return rows;
}

class ObjectSteering : public testing::Test {
 protected:
  v1::StreamOpened open(const v1::OpenStream& request) {
    const v1::StreamOpened stream = server_.client().open(request);
    subscriber_.attach(stream);
    subscriber_.giveCredit(1 << 24);
    return stream;
  }
  v1::Status call(const v1::Request& request) { return server_.client().call(request).status(); }

  TestServer server_{2};
  MockSubscriber subscriber_ = server_.dataSubscriber();
};

TEST_F(ObjectSteering, AnObjectHasThePosesExactlyAndStaysWhereItIs) {
  const auto stream = open(lockstep(4));
  EXPECT_EQ(call(move(stream, "tall_block", kBegin)).code(), v1::CODE_OK);
  EXPECT_EQ(call(move(stream, "tall_block", kBegin + Vec3d{0.1, 0, 0})).code(), v1::CODE_OK);
  for (int i = 0; i < 2; ++i) call(steerTo(stream, 0));  // of the camera alone
  const std::vector<Row> rows = rowsOf(subscriber_.receiveAll(2)[1], 1);
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[1].x, kBegin.x);
  for (int i = 2; i < 5; ++i) EXPECT_EQ(rows[i].x, kBegin.x + 0.1);
  EXPECT_EQ(std::abs(rows[1].qw), 1);
}

TEST_F(ObjectSteering, OthersFollowTheirPaths) {
  const auto stream = open(lockstep(3));
  for (int i = 0; i < 3; ++i) call(move(stream, "tall_block", kBegin));
  const std::vector<Row> rows = rowsOf(subscriber_.receiveAll(2)[1], 0);
  ASSERT_EQ(rows.size(), 4u);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(2 * std::acos(std::abs(rows[i].qw)), i * 0.002 * M_PI / 2, 1e-7);
}

TEST_F(ObjectSteering, TheCameraGoesOnAsBefore) {
  v1::OpenStream request = lockstep(3);
  request.mutable_truth(0)->set_name("pose");
  const auto stream = open(request);
  call(steerTo(stream, 0.2));
  call(move(stream, "tall_block", kBegin));
  call(move(stream, "tall_block", kBegin));
  const TruthSamples samples = samplesOf(subscriber_.receiveAll(2)[1]);
  for (int i = 1; i < 4; ++i) {
    double x;
    std::memcpy(&x, samples.at(i).elements.data(), sizeof x);
    EXPECT_EQ(x, kCornellX - 0.2);
  }
}

TEST_F(ObjectSteering, MakesEventsAndIsReplayedByteForByte) {
  const auto stream = open(lockstep(8));
  for (int i = 1; i <= 8; ++i) call(move(stream, "tall_block", kBegin + Vec3d{0.02 * i * i, 0, 0}));
  auto packets = subscriber_.receiveAll(2);
  EXPECT_GT(eventsOf(packets[0]).size(), 100u);
  const v1::OpenStream again = describe(server_.client(), stream);
  EXPECT_EQ(again.objects(1).path().keyframes().keys_size(), 9);
  auto repeated = server_.run(again);
  for (std::uint32_t channel : {0u, 1u}) {
    packets[channel].pop_back(), repeated[channel].pop_back();  // END tells why
    EXPECT_EQ(comparableBytes(packets[channel]), comparableBytes(repeated[channel]));
  }
}

TEST_F(ObjectSteering, TheNewestPoseOfEachCountsWithOtherClocks) {
  v1::OpenStream request = lockstep(5);
  request.mutable_timing()->set_clock(v1::CLOCK_FAST);
  request.mutable_timing()->set_steerable(true);
  const auto stream = server_.client().open(request);  // nothing is rendered before the attach
  call(move(stream, "tall_block", kBegin + Vec3d{1, 0, 0}));
  call(move(stream, "short_block", kBegin));
  call(move(stream, "tall_block", kBegin));
  subscriber_.attach(stream);
  subscriber_.giveCredit(1 << 24);
  const Packets poses = subscriber_.receiveAll(2)[1];
  EXPECT_EQ(rowsOf(poses, 0).at(1).x, kBegin.x);
  EXPECT_EQ(rowsOf(poses, 1).at(1).x, kBegin.x);
}

TEST_F(ObjectSteering, BadCallsAreRefusedWithTheirField) {
  const auto stream = open(lockstep(5));
  const auto expect = [&](v1::Request request, v1::Code code, const std::string& field,
                          const std::string& told) {
    const v1::Status status = call(request);
    EXPECT_EQ(status.code(), code) << status.ShortDebugString();
    EXPECT_EQ(status.field(), field) << status.ShortDebugString();
    EXPECT_NE(status.message().find(told), std::string::npos) << status.ShortDebugString();
  };
  v1::Request turned = move(stream, "tall_block", kBegin), twice = turned, many = turned;
  turned.mutable_steer()->mutable_objects(0)->mutable_pose()->clear_rotation();
  *twice.mutable_steer()->add_objects() = twice.steer().objects(0);
  while (many.steer().objects_size() < 65) many.mutable_steer()->add_objects();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect(move(stream, "light", kBegin), v1::CODE_NOT_FOUND, "objects[0].name",
         "it has: short_block, tall_block");
  expect(move(stream, "tall_block", {nan, 0, 0}), v1::CODE_INVALID_ARGUMENT, "objects[0].pose.position.x",
         "nan");
  expect(turned, v1::CODE_INVALID_ARGUMENT, "objects[0].pose.rotation", "length");
  expect(twice, v1::CODE_INVALID_ARGUMENT, "objects[1].name", "twice");
  expect(many, v1::CODE_INVALID_ARGUMENT, "objects", "more than 64");
}

TEST_F(ObjectSteering, TheKeysOfAllPathsAreBounded) {
  v1::OpenStream endless = lockstep(5);
  endless.mutable_timing()->set_duration_s(0);
  EXPECT_EQ(server_.client().open(endless).frames(), 33'332u);  // 100000 keys over three paths
}

}  // namespace
}  // namespace saccade
