// Paths by request: motions, keyframes, and what the reply says of their speed.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "mock/test_server.h"

namespace saccade {
namespace {

v1::OpenStream motionRequest(v1::MotionKind kind) {
  v1::OpenStream request = tinyRequest();
  request.mutable_trajectory()->mutable_motion()->set_kind(kind);
  return request;
}

void addKey(v1::Keyframes& keyframes, double time_s, double x, double w = 1) {
  v1::Keyframe& key = *keyframes.add_keys();
  key.set_time_s(time_s);
  key.mutable_position()->set_x(2.78 + x);
  key.mutable_position()->set_y(2.73);
  key.mutable_position()->set_z(-7.5);
  key.mutable_rotation()->set_z(w);  // half a turn about the viewing axis: the scene's y is up
}

std::string bytesOf(TestServer& server, const v1::OpenStream& request) {
  return comparableBytes(server.run(request)[0]);
}

// A folder with one scene: a wall at depth 5 that fills every view.
class WallScene {
 public:
  WallScene() {
    std::filesystem::create_directories(folder_ / "wall");
    std::ofstream(folder_ / "wall/scene.xml") << R"(<scene version="3.0.0">
      <sensor type="perspective"><float name="fov" value="40"/><transform name="to_world">
        <lookat origin="0, 0, 0" target="0, 0, 1" up="0, 1, 0"/></transform></sensor>
      <shape type="rectangle">
        <transform name="to_world"><scale value="100"/><translate z="5"/></transform>
        <emitter type="area"><rgb name="radiance" value="1, 1, 1"/></emitter></shape></scene>)";
  }
  ~WallScene() { std::filesystem::remove_all(folder_); }
  std::string folder() const { return folder_.string(); }

 private:
  const std::filesystem::path folder_ = testing::TempDir() + "wall_scene_" + std::to_string(getpid());
};

TEST(PathRequest, TheReplyTellsThePixelSpeedOfATruckPastAWall) {
  const WallScene scene;
  TestServer server(1, scene.folder());
  v1::OpenStream request = motionRequest(v1::MOTION_KIND_TRUCK);
  request.set_scene("wall");
  request.mutable_view()->set_fov_x_deg(90);  // the focal length is half the width, 16 pixels
  request.mutable_trajectory()->mutable_motion()->set_speed(-0.5);
  const v1::StreamOpened opened = server.client().open(request);
  const double px = 16 * 0.5 / 500 / 5;
  EXPECT_NEAR(opened.px_per_frame_p50(), px, 1e-4 * px);
  EXPECT_NEAR(opened.px_per_frame_p99(), px, 1e-4 * px);
}

// The wall is at depth 5 from the scene's camera, whose rotation stays where the request has none.
TEST(PathRequest, AMotionStartsWhereItIsTold) {
  const WallScene scene;
  TestServer server(1, scene.folder());
  v1::OpenStream request = motionRequest(v1::MOTION_KIND_TRUCK);
  request.set_scene("wall");
  request.mutable_view()->set_fov_x_deg(90);  // the focal length is 16 pixels
  v1::Motion& motion = *request.mutable_trajectory()->mutable_motion();
  motion.set_speed(0.5);
  motion.mutable_start()->mutable_position()->set_z(3);
  EXPECT_NEAR(server.client().open(request).px_per_frame_p50(), 16 * 0.5 / 500 / 2, 1e-6);
  motion.mutable_start()->mutable_rotation()->set_w(1);  // looks along z too, and is upside down
  EXPECT_NEAR(server.client().open(request).px_per_frame_p50(), 16 * 0.5 / 500 / 2, 1e-6);
  motion.mutable_start()->clear_position();
  EXPECT_NEAR(server.client().open(request).px_per_frame_p50(), 16 * 0.5 / 500 / 5, 1e-6);
  motion.mutable_start()->mutable_rotation()->set_x(1e3);  // half a turn: away from the wall
  EXPECT_EQ(server.client().open(request).px_per_frame_p50(), 0);
}

TEST(PathRequest, EveryKindOfMotionMovesThePicture) {
  TestServer server;
  const auto* kinds = v1::MotionKind_descriptor();
  for (int i = 1; i < kinds->value_count(); ++i) {
    v1::OpenStream request = motionRequest(v1::MotionKind(kinds->value(i)->number()));
    request.mutable_trajectory()->mutable_motion()->set_speed(1);
    EXPECT_GT(server.client().open(request).px_per_frame_p50(), 0) << kinds->value(i)->name();
  }
}

TEST(PathRequest, AMotionMayBeAskedForInPixelsPerFrame) {
  TestServer server;
  for (const v1::MotionKind kind : {v1::MOTION_KIND_TRUCK, v1::MOTION_KIND_PAN, v1::MOTION_KIND_ORBIT}) {
    v1::OpenStream request = motionRequest(kind);
    request.mutable_trajectory()->mutable_motion()->set_px_per_frame(0.1);
    request.mutable_timing()->set_duration_s(0.01);
    EXPECT_NEAR(server.client().open(request).px_per_frame_p50(), 0.1, 0.003) << kind;
  }
}

TEST(PathRequest, FieldsThatAKindDoesNotUseAreNotKept) {
  TestServer server;
  const auto kept = [&](v1::MotionKind kind) {
    v1::OpenStream request = motionRequest(kind);
    v1::Motion& motion = *request.mutable_trajectory()->mutable_motion();
    motion.set_speed(3), motion.set_turn_s(0), motion.set_seed(4);
    return server.client().open(request).resolved().trajectory().motion();
  };
  const v1::Motion pan = kept(v1::MOTION_KIND_PAN);
  EXPECT_TRUE(pan.has_turn_s() && pan.seed() == 0);
  for (const v1::MotionKind kind : {v1::MOTION_KIND_SHAKE, v1::MOTION_KIND_RANDOM, v1::MOTION_KIND_ROAM}) {
    const v1::Motion seeded = kept(kind);
    EXPECT_TRUE(!seeded.has_turn_s() && seeded.seed() == 4);
  }
}

TEST(PathRequest, TheSeedOfAMotionChangesThePath) {
  TestServer server;
  for (const v1::MotionKind kind : {v1::MOTION_KIND_SHAKE, v1::MOTION_KIND_RANDOM, v1::MOTION_KIND_ROAM}) {
    v1::OpenStream request = motionRequest(kind);
    request.mutable_trajectory()->mutable_motion()->set_px_per_frame(3);
    const std::string bytes = bytesOf(server, request);
    EXPECT_EQ(bytesOf(server, request), bytes);
    request.mutable_trajectory()->mutable_motion()->set_seed(1);
    EXPECT_NE(bytesOf(server, request), bytes);
  }
}

v1::OpenStream roamRequest(double clearance) {
  v1::OpenStream request = motionRequest(v1::MOTION_KIND_ROAM);
  v1::Motion& motion = *request.mutable_trajectory()->mutable_motion();
  motion.set_px_per_frame(3);
  motion.set_clearance(clearance);
  return request;
}

TEST(PathRequest, ARoamHasItsClearanceInTheReplyAndItsSpeed) {
  TestServer server;
  v1::OpenStream request = roamRequest(0.4);
  request.mutable_timing()->set_duration_s(0);  // the reply covers a period
  const v1::StreamOpened opened = server.client().open(request);
  EXPECT_EQ(opened.resolved().trajectory().motion().clearance(), 0.4);
  EXPECT_NEAR(opened.px_per_frame_p50(), 3, 0.5);
}

TEST(PathRequest, TheClearanceOfARoamChangesThePath) {
  TestServer server;
  const std::string bytes = bytesOf(server, roamRequest(0.4));
  EXPECT_EQ(bytesOf(server, roamRequest(0.4)), bytes);
  EXPECT_NE(bytesOf(server, roamRequest(0.5)), bytes);
}

TEST(PathRequest, ARoamWithoutRoomIsToldTheLargestClearance) {
  TestServer server;
  const v1::Status status = server.client().tryOpen(roamRequest(1e5));
  EXPECT_EQ(status.code(), v1::CODE_INVALID_ARGUMENT);
  EXPECT_EQ(status.field(), "trajectory.motion.clearance");
  const std::string before = "the largest found that works is ";
  const std::size_t at = status.message().find(before);
  ASSERT_NE(at, std::string::npos) << status.message();
  const double largest = std::stod(status.message().substr(at + before.size()));
  EXPECT_GT(largest, 0.5);
  EXPECT_EQ(server.client().tryOpen(roamRequest(largest)).code(), v1::CODE_OK);
}

TEST(PathRequest, ARoamThatSeesNothingIsToldItsStart) {
  TestServer server;
  v1::OpenStream request = roamRequest(0.1);
  request.mutable_trajectory()->mutable_motion()->mutable_start()->mutable_position()->set_y(1e6);
  EXPECT_EQ(server.client().tryOpen(request).field(), "trajectory.motion.start");
}

TEST(PathRequest, KeyframesAreTheSameAsTheirCsv) {
  TestServer server;
  v1::OpenStream keyed = tinyRequest(), csv = tinyRequest();
  v1::Keyframes& keyframes = *keyed.mutable_trajectory()->mutable_keyframes();
  addKey(keyframes, 0, 0);
  addKey(keyframes, 0.01, 0.25, -2);  // the same rotation, of another sign and length
  addKey(keyframes, 0.04, 0.5);
  csv.mutable_trajectory()->set_csv(
      "0 2.78 2.73 -7.5 0 0 1 0\n0.01 3.03 2.73 -7.5 0 0 1 0\n0.04 3.28 2.73 -7.5 0 0 1 0\n");
  const std::string bytes = bytesOf(server, keyed);
  EXPECT_EQ(bytes, bytesOf(server, csv));
  keyframes.set_interpolation(v1::INTERPOLATION_CUBIC);
  EXPECT_NE(bytes, bytesOf(server, keyed));
  keyframes.clear_interpolation();
  EXPECT_EQ(server.client().open(keyed).resolved().trajectory().keyframes().interpolation(),
            v1::INTERPOLATION_LINEAR);
}

TEST(PathRequest, KeyframesMayBeAsManyAsIsSaid) {
  TestServer server;
  v1::OpenStream request = tinyRequest();
  v1::Keyframes& keyframes = *request.mutable_trajectory()->mutable_keyframes();
  for (int i = 0; i < 100'000; ++i) addKey(keyframes, 0.001 * i, 1e-5 * i);
  EXPECT_EQ(server.client().tryOpen(request).code(), v1::CODE_OK);
  addKey(keyframes, 1000, 1);
  EXPECT_EQ(server.client().tryOpen(request).field(), "trajectory.keyframes.keys");
}

}  // namespace
}  // namespace saccade
