// Streams that end with their path: Timing.until_path_ends.
#include <gtest/gtest.h>

#include "app/request/refusal.h"
#include "app/request/resolve.h"

namespace saccade {
namespace {

// The poses are 0.25 s apart, and begin at a Unix time.
const char* kCsv = "1700000000.5 0 0 0 0 0 0 1\n1700000000.75 1 0 0 0 0 0 1\n1700000001 1 1 0 0 0 0 1\n";

v1::OpenStream request() {
  v1::OpenStream r;
  r.set_scene("a");
  r.mutable_view()->set_width(8), r.mutable_view()->set_height(6);
  r.mutable_timing()->set_frame_rate_hz(100);
  r.mutable_timing()->set_until_path_ends(true);
  r.add_sensors();
  return r;
}

ResolvedStream resolved(const v1::OpenStream& r) {
  SceneEntry scene;
  scene.name = "a", scene.trajectories = {"right"};
  return resolve(r, scene, {});
}

std::string faultOf(const v1::OpenStream& r) {
  try {
    resolved(r);
  } catch (const Refusal& refusal) {
    return refusal.field + ": " + refusal.what();
  }
  return {};
}

TEST(PathEnd, TheTextOfAPathGivesTheDuration) {
  v1::OpenStream r = request();
  r.mutable_trajectory()->set_csv(kCsv);
  const ResolvedStream stream = resolved(r);
  EXPECT_EQ(stream.frames, 50u);
  EXPECT_EQ(stream.request.timing().duration_s(), 0.5);
  EXPECT_FALSE(stream.request.timing().until_path_ends());
  EXPECT_EQ(stream.path_begin_ns, 1'700'000'000'500'000'000);
}

TEST(PathEnd, SoDoKeyframes) {
  v1::OpenStream r = request();
  for (const double t : {0.0, 0.3}) {
    v1::Keyframe& key = *r.mutable_trajectory()->mutable_keyframes()->add_keys();
    key.set_time_s(t), key.mutable_rotation()->set_w(1);
  }
  EXPECT_EQ(resolved(r).frames, 30u);
}

TEST(PathEnd, APathWithoutAnEndIsRefused) {
  v1::OpenStream r = request();
  r.mutable_trajectory()->set_name("right");
  EXPECT_EQ(faultOf(r),
            "timing.until_path_ends: only trajectory.keyframes and trajectory.csv have an end; give "
            "timing.duration_s");
  r.mutable_trajectory()->set_csv("0 0 0 0 0 0 0 1\n");
  EXPECT_EQ(faultOf(r), "timing.until_path_ends: the path has no pose after time 0; give timing.duration_s");
  r.mutable_trajectory()->set_csv(kCsv);
  r.mutable_timing()->set_duration_s(1);
  EXPECT_EQ(faultOf(r), "timing.until_path_ends: timing.duration_s is given too");
}

// Before any scene is loaded.
TEST(PathEnd, AFaultyTextIsRefusedAtOnce) {
  v1::OpenStream r = request();
  r.mutable_trajectory()->set_csv("0 0 0 0 0 0 0 1\n1 2 3\n");
  EXPECT_EQ(faultOf(r), "trajectory.csv: line 2: a line of 3 fields; expected 8: t x y z qx qy qz qw");
}

}  // namespace
}  // namespace saccade
