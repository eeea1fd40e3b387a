// Requests that move objects: what is refused, and what is filled in.
#include <gtest/gtest.h>

#include <limits>

#include "app/request/resolve.h"
#include "mock/accuracy_file.h"
#include "mock/bad_request.h"
#include "objects.h"

namespace saccade {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN(),
                 kInf = std::numeric_limits<double>::infinity();
constexpr auto kInvalid = v1::CODE_INVALID_ARGUMENT;

v1::ObjectPath& firstPath(v1::OpenStream& r) {
  return *r.mutable_objects(0)->mutable_path();
}
v1::ObjectSpeed& motion(v1::OpenStream& r) {
  return *firstPath(r).mutable_motion();
}
void addKeys(v1::Keyframes& keyframes, int count) {
  for (int i = 0; i < count; ++i) {
    v1::Keyframe& key = *keyframes.add_keys();
    key.set_time_s(i);
    key.mutable_rotation()->set_w(1);
  }
}
// The second of two good keys.
v1::Keyframe& secondKey(v1::OpenStream& r) {
  addKeys(*firstPath(r).mutable_keyframes(), 2);
  return *firstPath(r).mutable_keyframes()->mutable_keys(1);
}

// clang-format off
const std::vector<BadRequest> kBadObjects{
    {spinning(), [](auto& r) { r.mutable_objects(0)->set_name("teapot"); }, v1::CODE_NOT_FOUND, "objects[0].name",
     "'teapot'; it has: back_wall, ceiling, floor, left_wall, light, right_wall, short_block, tall_block"},
    {spinning(), [](auto& r) { addMotion(r, "absent", v1::OBJECT_MOTION_KIND_SPIN, 9); }, v1::CODE_NOT_FOUND,
     "objects[1].name", "'absent'"},  // by its place in the request, although it comes first by name
    {spinning(), [](auto& r) { r.mutable_objects(0)->clear_name(); }, kInvalid, "objects[0].name", "the name of an object"},
    {spinning(), [](auto& r) { *r.add_objects() = r.objects(0); }, kInvalid, "objects[1].name", "given twice"},
    {spinning(), [](auto& r) { while (r.objects_size() < 65) r.add_objects(); }, kInvalid, "objects", "more than 64"},
    {spinning(), [](auto& r) { while (r.objects_size() < 10'000) r.add_objects(); }, kInvalid, "objects", "more than 64"},
    {spinning(), [](auto& r) { r.mutable_objects(0)->clear_path(); }, kInvalid, "objects[0].path", "spin, orbit, slide, swing"},
    {spinning(), [](auto& r) { motion(r).clear_kind(); }, kInvalid, "objects[0].path.motion.kind", "spin, orbit, slide, swing"},
    {spinning(), [](auto& r) { motion(r).set_kind(v1::ObjectMotionKind(9)); }, kInvalid, "objects[0].path.motion.kind",
     "OBJECT_MOTION_KIND_SWING"},
    {spinning(), [](auto& r) { motion(r).set_speed(0); }, kInvalid, "objects[0].path.motion.speed", "[1e-06, 1000000]"},
    {spinning(), [](auto& r) { motion(r).set_speed(kNan); }, kInvalid, "objects[0].path.motion.speed", "nan"},
    {spinning(), [](auto& r) { motion(r).set_speed(-2e6); }, kInvalid, "objects[0].path.motion.speed", "of either sign"},
    {spinning(), [](auto& r) { firstPath(r).set_csv(""); }, kInvalid, "objects[0].path.csv", "pose"},
    {spinning(), [](auto& r) { firstPath(r).set_csv("0 0 0 0 0 0 0 1\n1 2 3\n"); }, kInvalid, "objects[0].path.csv",
     "line 2: a line of 3"},
    {spinning(), [](auto& r) { firstPath(r).set_csv(std::string((8 << 20) + 1, '#')); }, kInvalid, "objects.path.csv", "8388608"},
    {spinning(),
     [](auto& r) { firstPath(r).set_csv(std::string(4200 << 10, '#')), addObject(r, "light").set_csv(std::string(4200 << 10, '#')); },
     kInvalid, "objects[1].path.csv", "8388608"},
    {spinning(), [](auto& r) { firstPath(r).mutable_keyframes(); }, kInvalid, "objects[0].path.keyframes.keys", "100000"},
    {spinning(),
     [](auto& r) { addKeys(*firstPath(r).mutable_keyframes(), 50'001), addKeys(*r.mutable_trajectory()->mutable_keyframes(), 50'000); },
     kInvalid, "objects.path.keyframes.keys", "100000"},
    {spinning(), [](auto& r) { secondKey(r), firstPath(r).mutable_keyframes()->set_interpolation(v1::Interpolation(7)); }, kInvalid,
     "objects[0].path.keyframes.interpolation", "INTERPOLATION_CUBIC"},
    {spinning(), [](auto& r) { secondKey(r).set_time_s(4e-10); }, kInvalid, "objects[0].path.keyframes.keys[1].time_s", "not later"},
    {spinning(), [](auto& r) { secondKey(r).mutable_position()->set_y(kInf); }, kInvalid,
     "objects[0].path.keyframes.keys[1].position.y", "inf"},
    {spinning(), [](auto& r) { secondKey(r).clear_rotation(); }, kInvalid, "objects[0].path.keyframes.keys[1].rotation", "length"},
    {spinning(),
     [](auto& r) { firstPath(r).set_csv("0 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n"), r.mutable_trajectory()->set_csv("1.7e9 0 0 0 0 0 0 1\n"); },
     kInvalid, "objects[0].path.csv", "one clock"},
    {spinning(),
     [](auto& r) { firstPath(r).set_csv("0 0 0 0 0 0 0 1\n"), addObject(r, "light").set_csv("2e9 0 0 0 0 0 0 1\n"); },
     kInvalid, "objects[1].path.csv", "one clock"},
    {spinning(), [](auto& r) { firstPath(r).mutable_own(); }, v1::CODE_NOT_FOUND, "objects[0].path.own", "it moves: none"},
    {spinning(), [](auto& r) { r.mutable_quality()->set_bake_error(0.1); }, kInvalid, "quality.bake_error", "leave out objects"},
    {spinning(), [](auto& r) { r.mutable_quality()->set_budget_ms(1e3); }, v1::CODE_UNAVAILABLE, "quality.budget_ms",
     "moving objects"},
};
// clang-format on

TEST(ObjectRequest, ABadOneIsRefusedWithItsField) {
  const AccuracyFile accuracy(testing::TempDir() + "object_test_" + std::to_string(getpid()));
  TestServer server(1, {}, accuracy.path());
  expectRefused(server, kBadObjects);
  v1::OpenStream pushed;
  pushed.set_pushed(true);
  addMotion(pushed, "tall_block", v1::OBJECT_MOTION_KIND_SPIN, 1);
  EXPECT_EQ(server.client().tryOpen(pushed).field(), "objects");
}

TEST(ObjectRequest, AMovingSceneHasTheMethodOfAStillOne) {
  TestServer server;
  v1::OpenStream request = spinning();
  request.add_further_views()->CopyFrom(request.view());
  const v1::OpenStream resolved = server.client().open(request).resolved();
  EXPECT_EQ(resolved.method().name(), "irradiance_cache");
  EXPECT_EQ(server.client().open(resolved).resolved().DebugString(), resolved.DebugString());
}

TEST(ObjectRequest, TheReplyHasTheObjectsByNameWithTheirDefaults) {
  TestServer server;
  v1::OpenStream request = spinning("tall_block", -30);
  addKeys(*addObject(request, "light").mutable_keyframes(), 1);
  addObject(request, "short_block").set_csv("5 0 0 0 0 0 0 1\n");
  const v1::OpenStream resolved = server.client().open(request).resolved();
  const auto& objects = resolved.objects();
  ASSERT_EQ(objects.size(), 3);
  EXPECT_EQ(objects[0].name(), "light");
  EXPECT_EQ(objects[0].path().keyframes().interpolation(), v1::INTERPOLATION_LINEAR);
  EXPECT_EQ(objects[1].path().csv(), "5 0 0 0 0 0 0 1\n");
  EXPECT_EQ(objects[2].path().DebugString(), request.objects(0).path().DebugString());
}

TEST(ObjectRequest, TheOrderOfObjectsMakesNoOtherFeed) {
  const SceneEntry scene = SceneLibrary(SACCADE_SOURCE_DIR "/scenes").find("cornell-box").value();
  const MeasuredTables tables{openAccuracySource({}), openSimplificationSource({})};
  const auto key = [&](const v1::OpenStream& r) { return resolve(r, scene, tables).feedKey(); };
  v1::OpenStream one = spinning("tall_block"), other = spinning("light", 9),
                 faster = spinning("tall_block", 721);
  addMotion(one, "light", v1::OBJECT_MOTION_KIND_SPIN, 9);
  addMotion(other, "tall_block", v1::OBJECT_MOTION_KIND_SPIN, 720);
  EXPECT_EQ(key(one), key(other));
  EXPECT_NE(key(spinning()), key(faster));
  EXPECT_NE(key(spinning()), key(stillRequest()));
}

}  // namespace
}  // namespace saccade
