// Motions of objects against their formulas.
#include "scene/motion/object_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene/files/scene_error.h"
#include "scene/motion/bodies.h"

namespace saccade {
namespace {

constexpr TimeNs kSecond{1'000'000'000};

Mesh triangle(const std::string& name, Vec3 corner) {
  Mesh m;
  m.name = name;
  m.positions = {corner, corner + Vec3{2, 0, 0}, corner + Vec3{0, 4, 6}, {}};
  m.triangles = {{0, 1, 2}};
  return m;
}

// Seen by a camera that looks along -z, with y up: the box of all shapes is (0, 0, 0) to (12, 4, 6).
Scene twoTriangles() {
  Scene s;
  s.materials = {{}};
  s.meshes = {triangle("left", {0, 0, 0}), triangle("right", {10, 0, 0})};
  s.T_world_camera.rotation = {1, 0, 0, 0};
  const std::string names[]{"right"};
  setBodies(s, names);
  return s;
}

Trajectory pathOf(const std::string& text, const Scene& scene) {
  return makeObjectMotion(*parseObjectMotion(text), scene, scene.bodies.at(0));
}

void expectNear(Vec3d a, Vec3d b) {
  EXPECT_NEAR(a.x, b.x, 1e-9);
  EXPECT_NEAR(a.y, b.y, 1e-9);
  EXPECT_NEAR(a.z, b.z, 1e-9);
}

std::string faultOf(const auto& f) {
  try {
    f();
  } catch (const SceneError& fault) {
    return fault.what();
  }
  return "";
}

TEST(Bodies, HaveTheBoxOfTheirShapes) {
  const Scene s = twoTriangles();
  ASSERT_EQ(s.bodies.size(), 1u);
  EXPECT_EQ(s.bodies[0].low, (Vec3{10, 0, 0}));
  EXPECT_EQ(s.bodies[0].high, (Vec3{12, 4, 6}));
  EXPECT_EQ(s.meshes[0].body, kStands);
  EXPECT_EQ(s.meshes[1].body, 0);
}

TEST(Bodies, OfOneNameAreOne) {
  Scene s = twoTriangles();
  s.bodies.clear();
  for (Mesh& mesh : s.meshes) mesh.name = "both", mesh.body = kStands;
  const std::string names[]{"both"};
  setBodies(s, names);
  EXPECT_EQ(s.bodies.size(), 1u);
  EXPECT_EQ(s.bodies[0].low, (Vec3{0, 0, 0}));
  EXPECT_EQ(s.meshes[0].body, 0);
}

// The box is that of the shapes, so that a lamp on an arm does not move the centre of the arm.
TEST(Bodies, LampsMoveWithTheShapesOfTheirName) {
  Scene s = twoTriangles();
  s.bodies.clear();
  s.point_lights = {{{0, 0, 9}, {1, 1, 1}, "right"}, {{1, 2, 3}, {1, 1, 1}}};
  const std::string names[]{"right"};
  setBodies(s, names);
  EXPECT_EQ(s.bodies[0].high, (Vec3{12, 4, 6}));
  EXPECT_EQ(s.point_lights[0].body, 0);
  EXPECT_EQ(s.point_lights[1].body, kStands);
  EXPECT_EQ(lampBodies(s), (std::vector<char>{true}));
}

TEST(Bodies, OfLampsAloneHaveTheBoxOfTheirPositions) {
  Scene s = twoTriangles();
  s.bodies.clear();
  s.point_lights = {{{1, 2, 3}, {1, 1, 1}, "two"}};
  s.spot_lights = {{{3, 2, 1}, {0, 0, 1}, {1, 1, 1}, 0.1f, 0.2f, "two"}};
  s.directional_lights = {{{0, 0, 1}, {1, 1, 1}, "sun"}};
  EXPECT_EQ(objectNames(s), (std::set<std::string>{"left", "right", "sun", "two"}));
  const std::string names[]{"left", "sun", "two"};
  setBodies(s, names);
  EXPECT_TRUE(s.bodies[0].has_shapes);
  EXPECT_FALSE(s.bodies[1].has_shapes || s.bodies[2].has_shapes);
  EXPECT_EQ(s.bodies[1].centre(), (Vec3{0, 0, 0}));
  EXPECT_EQ(s.bodies[2].centre(), (Vec3{2, 2, 2}));
  EXPECT_EQ(lampBodies(s), (std::vector<char>{false, true, true}));
}

TEST(Bodies, ThatAreAbsentOrTwiceAreRefused) {
  Scene s = twoTriangles();
  s.bodies.clear();
  const std::string absent[]{"lef"}, twice[]{"left", "left"};
  EXPECT_EQ(faultOf([&] { setBodies(s, absent); }), "the scene has no object 'lef'; it has: left, right");
  s.bodies.clear();
  EXPECT_EQ(faultOf([&] { setBodies(s, twice); }), "the object 'left' is given twice");
}

TEST(ObjectMotion, SpinTurnsAboutTheCentreCounterClockwiseSeenFromAbove) {
  const Scene s = twoTriangles();
  const Pose at = pathOf("spin:90", s).at(kSecond);
  expectNear(at.position, {11, 2, 3});
  expectNear(rotate(at.rotation, {1, 0, 0}), {0, 0, -1});
  expectNear(rotate(pathOf("spin:90", s).at(9 * kSecond).rotation, {1, 0, 0}), {0, 0, -1});  // on and on
}

TEST(ObjectMotion, OrbitGoesAroundTheMiddleOfTheScene) {
  const Scene s = twoTriangles();
  const Trajectory path = pathOf("orbit:30", s);
  for (int i = 0; i < 12; ++i) {
    const double angle = i * std::numbers::pi / 6;
    expectNear(path.at(i * kSecond).position, {6 + 5 * std::cos(angle), 2, 3 - 5 * std::sin(angle)});
  }
}

TEST(ObjectMotion, SlideGoesToTheRightAndTurnsBack) {
  const Scene s = twoTriangles();
  expectNear(pathOf("slide:0.5", s).at(kSecond / 2).position, {11.25, 2, 3});
  expectNear(pathOf("slide:0.5", s).at(kSecond * 3 / 2).position, {11.25, 2, 3});
  expectNear(pathOf("slide:-0.5", s).at(kSecond / 2).position, {10.75, 2, 3});
}

TEST(ObjectMotion, SwingIsASineWithThisGreatestSpeed) {
  const Scene s = twoTriangles();
  const Trajectory path = pathOf("swing:0.5", s);
  const double amplitude = 0.5 * 2 / (2 * std::numbers::pi);
  expectNear(path.at(kSecond / 2).position, {11 + amplitude, 2, 3});
  expectNear(path.at(kSecond).position, {11, 2, 3});
  EXPECT_NEAR(path.velocityAt(TimeNs(0)).linear.x, 0.5, 1e-9);
}

TEST(ObjectMotion, RefusesWhatItCannotRead) {
  EXPECT_FALSE(parseObjectMotion("spin"));
  EXPECT_EQ(faultOf([] { parseObjectMotion("dolly:1"); }),
            "'dolly' is not a motion of an object; there are: spin, orbit, slide, swing");
  EXPECT_NE(faultOf([] { parseObjectMotion("spin:fast"); }).find("is not KIND:SPEED"), std::string::npos);
  EXPECT_NE(faultOf([] { parseObjectMotion("spin:0"); }).find("spin:0: of either sign"), std::string::npos);
}

}  // namespace
}  // namespace saccade
