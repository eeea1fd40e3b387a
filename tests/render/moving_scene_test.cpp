// Bodies in the renderer, against scenes whose vertices are moved instead.
#include <gtest/gtest.h>

#include "render/moving_frames.h"
#include "render/moving_room.h"
#include "render/world/changing_light.h"

namespace saccade {
namespace {

using namespace test;

// The room with the shapes of this name moved in the file.
Scene movedByHand(const std::string& name, const RigidMotion& motion) {
  Scene s = movingRoom();
  for (Mesh& mesh : s.meshes) {
    if (mesh.name != name) continue;
    for (Vec3& p : mesh.positions) p = motion.point(p);
    for (Vec3& n : mesh.normals) n = motion.direction(n);
  }
  for (Sphere& sphere : s.spheres)
    if (sphere.name == name) sphere.center = motion.point(sphere.center);
  return s;
}

TEST(MovingScene, LooksAsIfItsVerticesHadMoved) {
  for (const std::string name : {"card", "ball", "lamp"}) {
    const auto scene = withBodies({name});
    const Body& body = scene->description().bodies[0];
    const Pose step = name == "lamp" ? Pose{{0.3, 0.1, 0.2}, axisAngle({0.1, 0.2, 0.1})} : kMoved;
    const PosedScene posed(scene, {standing(body, step)});
    const PosedScene still(std::make_shared<RenderScene>(movedByHand(name, motionBy(body, step))));
    const Frame a = render(posed, posed), b = render(still, still);
    EXPECT_LT(meanDifference(a.g.z, b.g.z), 1e-5) << name;
    EXPECT_LT(meanDifference(a.g.nx, b.g.nx), 1e-5) << name;
    EXPECT_LT(meanDifference(a.g.ny, b.g.ny), 1e-5) << name;
    EXPECT_LT(meanDifference(a.samples.I2, b.samples.I2), 2e-3) << name;  // of 0.6: the same paths but few
  }
}

TEST(MovingScene, ShowsWhichBodyAPixelHas) {
  const auto scene = withBodies({"ball", "card"});
  const auto& bodies = scene->description().bodies;
  const PosedScene posed(scene, {standing(bodies[0]), standing(bodies[1])});
  const Frame frame = render(posed, posed);
  int ball = 0, card = 0, rest = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const std::uint32_t body = frame.g.body.at(x, y);
      ASSERT_LE(body, 2u);
      ++(body == 1 ? ball : body == 2 ? card : rest);
    }
  EXPECT_GT(ball, 10);
  EXPECT_GT(card, 10);
  EXPECT_GT(rest, kSize * kSize / 2);
}

// A body that is declared but stands changes no pixel.
TEST(MovingScene, ThatStandsIsTheSameAsAStillOne) {
  const auto scene = withBodies({"card", "ball"});
  const auto& bodies = scene->description().bodies;
  const PosedScene posed(scene, {standing(bodies[0]), standing(bodies[1])});
  const PosedScene still(std::make_shared<RenderScene>(movingRoom()));
  const Frame a = render(posed, posed), b = render(still, still);
  EXPECT_EQ(meanDifference(a.g.z, b.g.z), 0);
  EXPECT_EQ(meanDifference(a.samples.I2, b.samples.I2), 0);
  EXPECT_EQ(meanDifference(a.g.motion_x, b.g.motion_x), 0);
}

TEST(MovingScene, MotionVectorsFollowTheBody) {
  const auto scene = withBodies({"card"});
  const Body& body = scene->description().bodies[0];
  const PosedScene now(scene, {standing(body, kMoved)}), before(scene, {standing(body)});
  const Frame frame = render(now, before);
  const Camera camera(scene->description().T_world_camera, pinhole(80, kSize, kSize));
  const RigidMotion motion = motionBy(body, kMoved);
  int seen = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      if (frame.g.body.at(x, y) != 1) {
        EXPECT_EQ(frame.g.motion_x.at(x, y), 0);
        continue;
      }
      ++seen;
      const Vec3 d = camera.direction(static_cast<float>(x), static_cast<float>(y));
      const Vec3 rest = motion.restPoint(camera.origin + d * frame.g.z.at(x, y));
      const auto was = camera.projectDirection(rest - camera.origin);
      EXPECT_NEAR(frame.g.motion_x.at(x, y), was.x - static_cast<float>(x), 2e-3);
      EXPECT_NEAR(frame.g.motion_y.at(x, y), was.y - static_cast<float>(y), 2e-3);
      EXPECT_NEAR(frame.g.z_in_prev.at(x, y), was.z, 1e-5);
    }
  EXPECT_GT(seen, 10);
}

// Many bodies share boxes, which hold each of them at both times.
TEST(MovedBodies, LieInTheirBoxes) {
  for (const int count : {1, 16, 100}) {
    Scene s = movingRoom();
    std::vector<std::string> names;
    for (int i = 0; i < count; ++i) {
      const auto u = [&](unsigned k) { return toUnit(mix32(static_cast<std::uint32_t>(i) * 4 + k)) - 0.5f; };
      s.meshes.push_back(quad({u(0), u(1), u(2)}, {0.05f, 0, 0}, {0, 0.05f, 0}, 0));
      s.meshes.back().positions.pop_back();
      names.push_back(s.meshes.back().name = "body" + std::to_string(i));
    }
    setBodies(s, names);
    const auto scene = std::make_shared<RenderScene>(std::move(s));
    const auto& bodies = scene->description().bodies;
    std::vector<Trajectory> at_first, then;
    for (const Body& body : bodies)
      at_first.push_back(standing(body)), then.push_back(standing(body, {{0.1, 0, 0}, {}}));
    const MovedBodies moved(PosedScene(scene, then), PosedScene(scene, at_first));
    EXPECT_LE(moved.boxes().size(), 16u);
    for (const Body& body : bodies)
      for (const Vec3 corner :
           {body.low, body.high, body.low + Vec3{0.1f, 0, 0}, body.high + Vec3{0.1f, 0, 0}})
        EXPECT_TRUE(std::ranges::any_of(moved.boxes(), [&](const ShapeBox& box) {
          constexpr float kRounding = 1e-6f;
          const Vec3 below = corner - box.low, above = box.high - corner;
          return std::min({below.x, below.y, below.z, above.x, above.y, above.z}) > -kRounding;
        })) << count;
  }
}

// Segments from a point to places on the lamp, against the box of a body at both times.
TEST(ChangingLight, IsWhereASegmentToALampMeetsABody) {
  const auto scene = withBodies({"card"});
  const Body& body = scene->description().bodies[0];
  const PosedScene now(scene, {standing(body, {{0.3, 0, 0}, {}})}), before(scene, {standing(body)});
  const MovedBodies moved(now, before), none(now, now);
  const ChangingLight changing(now, before, moved);
  ShapeBox swept;
  for (const Vec3 shift : {Vec3{}, Vec3{0.3f, 0, 0}})
    swept.add(body.low + shift), swept.add(body.high + shift);
  const auto inside = [&](Vec3 p) {
    return p.x > swept.low.x && p.y > swept.low.y && p.z > swept.low.z && p.x < swept.high.x &&
           p.y < swept.high.y && p.z < swept.high.z;
  };
  int met = 0, free = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto u = [&](unsigned k) { return toUnit(mix32(static_cast<std::uint32_t>(i) * 8 + k)); };
    const Vec3 p{2 * u(0) - 1, 2 * u(1) - 1, 2 * u(2) - 1};
    bool meets = false;
    for (unsigned k = 0; k < 400 && !meets; ++k) {
      const auto v = [&](unsigned j) {
        return toUnit(mix32(static_cast<std::uint32_t>(i) * 1000 + 3 * k + j + 77));
      };
      const Vec3 lamp{0.6f * v(0) - 0.3f, -0.95f, 0.6f * v(1) - 0.3f};
      meets = inside(p + (lamp - p) * v(2));
    }
    if (meets) {
      EXPECT_TRUE(changing.at(p)) << i;
    }
    ++(meets ? met : free);
    if (!meets && !changing.at(p)) --free;
  }
  EXPECT_GT(met, 200);
  EXPECT_LT(free, 400);  // few more than the samples find
  EXPECT_FALSE(ChangingLight(now, now, none).at(body.centre()));
}

}  // namespace
}  // namespace saccade
