// Lamps of glTF files that an animation moves.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/gltf_scratch.h"
#include "scene/motion/bodies.h"
#include "scene/motion/own_motions.h"
#include "scene/motion/rigid_motion.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;

// One second in which a property of node 0 goes from `first` to `last`.
struct Move {
  std::string property;
  std::vector<float> first, last;
};
const Move kUp{"translation", {0, 0, 0}, {0, 2, 0}};
const float kHalf = std::sqrt(0.5f);
const Move kQuarterTurn{"rotation", {0, 0, 0, 1}, {kHalf, 0, 0, kHalf}};  // about x: -z goes up

Scene loadLamp(const std::string& type, const std::string& nodes, const Move& move,
               const std::string& attributes = {}) {
  const Scratch files;
  test::GltfArrays arrays = test::triangle();
  arrays.floats({0, 1}, "SCALAR");
  std::vector<float> values = move.first;
  values.insert(values.end(), move.last.begin(), move.last.end());
  arrays.floats(values, move.property == "rotation" ? "VEC4" : "VEC3");
  arrays.whole(std::vector<std::uint8_t>(12), 5121, "VEC4");
  arrays.floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
  return test::loadGltfOf(
      files, arrays,
      {R"("meshes":[{"primitives":[{"attributes":{"POSITION":0)" + attributes + "}}]}]", nodes,
       R"("animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":")" + move.property +
           R"("}}],"samplers":[{"input":1,"output":2}]}])",
       R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":")" + type + R"("}]}})"});
}

bool tellsOfTheLamp(const Scene& scene) {
  return std::ranges::any_of(scene.unread, [](const auto& s) { return s.starts_with("the lamp lamp"); });
}

constexpr const char* kLampAlone =
    R"("nodes":[{"name":"lamp","extensions":{"KHR_lights_punctual":{"light":0}}},
  {"mesh":0,"name":"it"}])";
constexpr const char* kLampOnAnArm = R"("nodes":[{"name":"arm","children":[1,2]},
  {"name":"lamp","translation":[0,0,-3],"extensions":{"KHR_lights_punctual":{"light":0}}},
  {"mesh":0,"name":"it"}])";

// The motion of its only body from the place of the file.
RigidMotion motionAt(Scene& scene, TimeNs t) {
  const std::string names[]{scene.motions.at(0).name};
  if (scene.bodies.empty()) setBodies(scene, names);
  return motionOf(scene.bodies[0], makeOwnMotion(scene.motions[0], scene, scene.bodies[0]).at(t));
}

TEST(GltfMovingLamps, APointFollowsItsNode) {
  Scene scene = loadLamp("point", kLampAlone, kUp);
  EXPECT_EQ(objectNames(scene), (std::set<std::string>{"it", "lamp"}));
  const RigidMotion motion = motionAt(scene, 500ms);
  EXPECT_EQ(scene.point_lights.at(0).body, 0);
  EXPECT_EQ(scene.meshes.at(0).body, kStands);
  expectNear(motion.point(scene.point_lights[0].position), {0, 1, 0}, 1e-6);
  EXPECT_FALSE(tellsOfTheLamp(scene));
}

TEST(GltfMovingLamps, ASpotAndASunTurn) {
  for (const std::string type : {"spot", "directional"}) {
    Scene scene = loadLamp(type, kLampAlone, kQuarterTurn);
    const RigidMotion motion = motionAt(scene, 500ms);
    const Vec3 axis =
        type == "spot" ? scene.spot_lights.at(0).axis : scene.directional_lights.at(0).direction;
    expectNear(motion.direction(axis), {0, kHalf, -kHalf}, 1e-5);
  }
}

TEST(GltfMovingLamps, ABodyHasShapesAndLampsOfItsNode) {
  Scene scene = loadLamp("spot", kLampOnAnArm, kQuarterTurn);
  const RigidMotion motion = motionAt(scene, 1s);
  EXPECT_EQ(scene.bodies[0].name, "arm");
  EXPECT_EQ(scene.meshes.at(0).body, 0);
  expectNear(motion.point(scene.spot_lights.at(0).position), {0, 3, 0}, 1e-5);
  expectNear(motion.direction(scene.spot_lights[0].axis), {0, 1, 0}, 1e-5);
  EXPECT_EQ(scene.bodies[0].high, (Vec3{1, 1, 0}));  // that of the shape alone
}

// A point shines into all directions, so that its turning is no motion.
TEST(GltfMovingLamps, APointThatTurnsStands) {
  EXPECT_TRUE(loadLamp("point", kLampAlone, kQuarterTurn).motions.empty());
}

// The mesh follows a joint, and its node does not move it.
TEST(GltfMovingLamps, ALampBelowASkinStandsAndIsTold) {
  const std::string nodes = R"("skins":[{"joints":[2]}],"nodes":[
    {"mesh":0,"skin":0,"name":"it","children":[1]},
    {"name":"lamp","extensions":{"KHR_lights_punctual":{"light":0}}},{"name":"joint"}])";
  EXPECT_TRUE(tellsOfTheLamp(loadLamp("point", nodes, kUp, R"(,"JOINTS_0":3,"WEIGHTS_0":4)")));
}

}  // namespace
}  // namespace saccade
