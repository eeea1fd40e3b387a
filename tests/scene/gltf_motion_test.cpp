// Animations and cameras of glTF files.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/gltf_scratch.h"
#include "scene/library/scene_format.h"
#include "scene/library/scene_library.h"
#include "scene/motion/bodies.h"
#include "scene/motion/own_motions.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;
using test::GltfArrays;

// An animation of one property of node 0: keys are the accessor 1, values the accessor 2.
std::string animation(const std::string& path, const std::string& interpolation) {
  return R"("animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":")" + path +
         R"("}}],"samplers":[{"input":1,"output":2,"interpolation":")" + interpolation + R"("}]}])";
}

Scene loadMoving(const std::string& path, const std::string& interpolation, const std::vector<float>& times,
                 const std::vector<float>& values, const std::string& nodes = test::kTriangleNode) {
  const Scratch files;
  GltfArrays arrays = test::triangle();
  arrays.floats(times, "SCALAR");
  arrays.floats(values, path == "rotation" ? "VEC4" : "VEC3");
  return test::loadGltfOf(files, arrays, {test::kTriangleMesh, nodes, animation(path, interpolation)});
}

// Where the vertex (1, 0, 0) of the triangle is at a time, by the body's path.
Vec3d cornerAt(Scene scene, TimeNs t) {
  const OwnMotion& own = scene.motions.at(0);
  const std::string names[]{own.name};
  const Vec3d corner = toDouble(scene.meshes.at(0).positions.at(1));
  setBodies(scene, names);
  const Pose pose = own.path->at(t);
  return pose.position + rotate(pose.rotation, corner - toDouble(scene.bodies[0].centre()));
}

TEST(GltfAnimation, LinearIsALineBetweenKeys) {
  const Scene scene = loadMoving("translation", "LINEAR", {1, 2}, {0, 0, 0, 4, 0, 2});
  EXPECT_EQ(scene.motions.at(0).name, "it");
  expectNear(cornerAt(scene, 0s), {1, 0, 0}, 1e-6);  // held before the first key
  expectNear(cornerAt(scene, 1250ms), {2, 0, 0.5}, 1e-6);
  expectNear(cornerAt(scene, 9s), {5, 0, 2}, 1e-6);
}

TEST(GltfAnimation, StepJumpsAtTheKey) {
  const Scene scene = loadMoving("translation", "STEP", {0, 1}, {0, 0, 0, 4, 0, 0});
  expectNear(cornerAt(scene, 999'999'998ns), {1, 0, 0}, 1e-6);
  expectNear(cornerAt(scene, 1s), {5, 0, 0}, 1e-6);
}

// Hermite's curve with tangents per second [glTF 2.0, C.4]: x = 3 s^2 - 2 s^3 for tangents of 0, over 2
// seconds.
TEST(GltfAnimation, CubicFollowsItsTangents) {
  const Scene scene = loadMoving("translation", "CUBICSPLINE", {0, 2},
                                 {0, 0, 0, 0, 0, 0, 0, 3, 0, 0, -3, 0, 1, 0, 0, 0, 0, 0});
  for (const double s : {0.1, 0.35, 0.5, 0.8}) {
    const double x = 3 * s * s - 2 * s * s * s,
                 bow = 2 * 3 * (s * s * s - 2 * s * s + s) - 2 * 3 * (s * s * s - s * s);
    const Vec3d at = cornerAt(scene, TimeNs{std::llround(2e9 * s)});
    EXPECT_NEAR(at.x, 1 + x, 1e-3) << s;
    EXPECT_NEAR(at.y, bow, 1e-3) << s;
  }
}

// The short way round, at constant speed, about the origin of the node rather than the centre of the body.
TEST(GltfAnimation, LinearRotationIsSpherical) {
  const float half = std::sqrt(0.5f);
  const Scene scene = loadMoving("rotation", "LINEAR", {0, 1}, {0, 0, 0, 1, 0, 0, -half, -half});
  for (const double s : {0.0, 0.3, 1.0}) {
    const double angle = s * std::numbers::pi / 2;
    expectNear(cornerAt(scene, TimeNs{std::llround(1e9 * s)}), {std::cos(angle), std::sin(angle), 0}, 1e-5);
  }
}

// A parent that turns while its child moves: the body follows both.
TEST(GltfAnimation, FollowsTheTree) {
  const float half = std::sqrt(0.5f);
  const Scene scene =
      loadMoving("rotation", "LINEAR", {0, 1}, {0, 0, 0, 1, 0, 0, half, half},
                 R"("nodes":[{"name":"arm","children":[1]},{"mesh":0,"name":"hand","translation":[2,0,0]}])");
  EXPECT_EQ(scene.meshes.at(0).name, "arm");  // it moves with the arm
  expectNear(cornerAt(scene, 500ms), {3 * half, 3 * half, 0}, 1e-5);
}

// A path that ends as it began repeats, and any other stands at its end.
TEST(GltfAnimation, ThatClosesRepeats) {
  const Scene closed = loadMoving("translation", "LINEAR", {0, 1, 2}, {0, 0, 0, 1, 0, 0, 0, 0, 0});
  expectNear(cornerAt(closed, 2500ms), {1.5, 0, 0}, 1e-6);
  const Scene open = loadMoving("translation", "LINEAR", {0, 1}, {0, 0, 0, 1, 0, 0});
  expectNear(cornerAt(open, 2500ms), {2, 0, 0}, 1e-6);
}

TEST(GltfAnimation, OfWhatStandsMovesNothing) {
  EXPECT_TRUE(loadMoving("translation", "LINEAR", {0, 1}, {1, 0, 0, 1, 0, 0}).motions.empty());
}

TEST(GltfAnimation, BeginsWhereItsFirstKeyIs) {
  const Scene scene = loadMoving("translation", "LINEAR", {0, 1}, {7, 0, 0, 8, 0, 0});
  EXPECT_EQ(scene.meshes.at(0).positions.at(1), (Vec3{8, 0, 0}));
  expectNear(cornerAt(scene, 0s), {8, 0, 0}, 1e-6);
}

constexpr const char* kCameras =
    R"("cameras":[{"type":"perspective","perspective":{"yfov":1,"aspectRatio":2}},
  {"type":"perspective","perspective":{"yfov":0.5}},{"type":"orthographic"}])";

// A camera of glTF looks along -z, with y up.
TEST(GltfCameras, AreNamedPaths) {
  const Scene scene =
      test::loadTriangle({kCameras, R"("nodes":[{"mesh":0},{"camera":0,"name":"front","translation":[0,0,5]},
    {"camera":1,"name":"side","rotation":[0,0.7071067811865476,0,0.7071067811865476]},{"camera":2}])"});
  EXPECT_NEAR(scene.fov_x_deg, 2 * std::atan(2 * std::tan(0.5)) * 180 / std::numbers::pi, 1e-9);
  EXPECT_EQ(scene.width, 640);
  EXPECT_EQ(scene.height, 320);
  EXPECT_EQ(scene.T_world_camera.position, (Vec3d{0, 0, 5}));
  expectNear(rotate(scene.T_world_camera.rotation, {0, 0, 1}), {0, 0, -1}, 1e-9);
  expectNear(rotate(scene.T_world_camera.rotation, {0, 1, 0}), {0, -1, 0}, 1e-9);
  ASSERT_EQ(scene.paths.size(), 2u);
  EXPECT_EQ(scene.paths[1].name, "side");
  expectNear(rotate(scene.paths[1].path.at(0s).rotation, {0, 0, 1}), {-1, 0, 0}, 1e-9);
  EXPECT_TRUE(std::ranges::any_of(
      scene.unread, [](const auto& s) { return s.ends_with("is orthographic, and not read"); }));
}

TEST(GltfCameras, MoveWithTheirNodes) {
  const Scene scene =
      loadMoving("translation", "LINEAR", {0, 1}, {0, 0, 5, 0, 0, 9},
                 std::string(R"("nodes":[{"camera":0,"name":"eye"},{"mesh":0}],)") + kCameras);
  expectNear(scene.paths.at(0).path.at(500ms).position, {0, 0, 7}, 1e-9);
  EXPECT_TRUE(scene.motions.empty());
}

// Without its keys, which are in the buffer.
TEST(GltfCameras, ThatMoveAreInTheOutline) {
  const Scratch files;
  GltfArrays arrays = test::triangle();
  arrays.floats({0, 1}, "SCALAR"), arrays.floats({0, 0, 5, 0, 0, 9}, "VEC3");
  const std::string file = test::writeGltf(files, arrays,
                                           {test::kTriangleMesh, kCameras, animation("translation", "LINEAR"),
                                            R"("nodes":[{"camera":0,"name":"eye"},{"mesh":0}])"});
  EXPECT_EQ(outlineGltf(file, {}).paths.at(0).name, "eye");
}

class GltfLibrary : public testing::Test {
 protected:
  GltfLibrary() {
    GltfArrays arrays = test::triangle();
    arrays.floats({0, 1}, "SCALAR");
    arrays.floats({0, 0, 0, 1, 0, 0}, "VEC3");
    files_.write("scenes/mine/data.bin", arrays.bytes());
    files_.write("scenes/mine/scene.gltf",
                 test::gltf({test::kTriangleMesh, kCameras, animation("translation", "LINEAR"), arrays.json(),
                             R"("nodes":[{"mesh":0,"name":"it"},{"camera":0,"name":"eye"}])"}));
  }
  const Scratch files_;
};

TEST_F(GltfLibrary, ListsWhatMovesAndTheCameras) {
  const SceneLibrary library(files_.path("scenes"));
  const SceneEntry entry = library.list().at(0);
  EXPECT_EQ(entry.unavailable, "");
  EXPECT_EQ(entry.trajectories.at(0), "eye");
  EXPECT_EQ(entry.objects.at(0).name, "it");
  EXPECT_EQ(entry.objects[0].motion, "animation");
  EXPECT_EQ(library.load("mine").motions.size(), 1u);
  EXPECT_EQ(library.loadTrajectory("mine", "eye").at(0s).position, Vec3d{});
}

TEST_F(GltfLibrary, MotionsBesideTheFileComeFirst) {
  files_.write("scenes/mine/motion.toml", "[it]\nmotion = \"spin:90\"\n");
  const Scene scene = SceneLibrary(files_.path("scenes")).load("mine");
  ASSERT_EQ(scene.motions.size(), 1u);
  EXPECT_EQ(scene.motions[0].text, "spin:90");
}

TEST_F(GltfLibrary, TrajectoriesBesideTheFileComeFirst) {
  files_.write("scenes/mine/trajectories/eye.csv", "0 1 2 3 0 0 0 1\n1 4 5 6 0 0 0 1\n");
  const SceneLibrary library(files_.path("scenes"));
  const std::vector<std::string> names = library.list().at(0).trajectories;
  EXPECT_EQ(std::ranges::count(names, "eye"), 1);
  EXPECT_TRUE(library.load("mine").paths.empty());
  EXPECT_EQ(library.loadTrajectory("mine", "eye").at(0s).position, (Vec3d{1, 2, 3}));
}

}  // namespace
}  // namespace saccade
