// Meshes that deform in the renderer, against bodies that move, and closed forms.
#include <gtest/gtest.h>

#include "render/deforming_shapes.h"
#include "render/moving_frames.h"
#include "render/moving_room.h"
#include "render/world/changing_light.h"

namespace saccade {
namespace {

using namespace test;
using namespace std::chrono_literals;

std::shared_ptr<const RenderScene> ready(Scene s) {
  return std::make_shared<RenderScene>(std::move(s));
}

PosedScene posedAt(const std::shared_ptr<const RenderScene>& scene, TimeNs t) {
  PosedScene posed(scene, {standing(scene->description().bodies.at(0))});
  posed.setTime(t);
  return posed;
}

// The card's vertices follow a node as the body follows its path.
TEST(DeformingScene, ThatMovesAsABodyLooksLikeIt) {
  const auto rigid = withBodies({"card"});
  const Body& body = rigid->description().bodies[0];
  const PosedScene moved(rigid, {standing(body, kMoved)}), rest(rigid, {standing(body)});
  Scene s = movingRoom();
  const Pose pose = Pose{toDouble(body.centre()), {}} * kMoved;
  setNodeMotion(s, "card", {pose.position - rotate(pose.rotation, toDouble(body.centre())), pose.rotation},
                1);
  const auto scene = ready(std::move(s));
  const Frame a = render(posedAt(scene, 1s), posedAt(scene, 0s)), b = render(moved, rest);
  for (ImageF GBuffer::*plane : {&GBuffer::z, &GBuffer::nx, &GBuffer::ny, &GBuffer::nz, &GBuffer::motion_x,
                                 &GBuffer::motion_y, &GBuffer::z_in_prev})
    EXPECT_LT(meanDifference(a.g.*plane, b.g.*plane), 1e-4);
  EXPECT_LT(meanDifference(a.samples.I2, b.samples.I2), 2e-3);  // of 0.6: the same paths but few
}

// A wall z = 2 + w s x before a pinhole camera. A ray (d, e, 1) meets it at z = 2 / (1 - w s d). There the
// wall was at 2 + v s x before.
TEST(DeformingScene, ShowsAWallThatBendsInClosedForm) {
  constexpr float kSlope = 0.4f, kNow = 0.75f, kBefore = 0.25f;
  Scene s = furnace(0.5f, 0);
  s.meshes = {quad({-4, -4, 2}, {0, 8, 0}, {8, 0, 0}, 0)};
  s.meshes[0].name = "wall";
  s.T_world_camera = {};
  setBending(s, "wall", kSlope, 1);
  const auto scene = ready(std::move(s));
  const Frame frame = render(posedAt(scene, 750ms), posedAt(scene, 250ms));
  const Camera camera(Pose{}, pinhole(80, kSize, kSize));
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const Vec3 d = camera.direction(static_cast<float>(x), static_cast<float>(y));
      const float z = 2 / (1 - kNow * kSlope * d.x);
      EXPECT_NEAR(frame.g.z.at(x, y), z, 1e-5f);
      const float was = 2 + kBefore * kSlope * d.x * z;
      const auto seen = camera.project({d.x * z, d.y * z, was});
      EXPECT_NEAR(frame.g.motion_x.at(x, y), seen.x - static_cast<float>(x), 1e-3f);
      EXPECT_NEAR(frame.g.motion_y.at(x, y), seen.y - static_cast<float>(y), 1e-3f);
      EXPECT_NEAR(frame.g.z_in_prev.at(x, y), was, 1e-5f);
      EXPECT_NEAR(frame.g.nx.at(x, y), kNow * kSlope / std::hypot(kNow * kSlope, 1.f), 1e-5f);
      EXPECT_EQ(frame.g.body.at(x, y), 1u);
    }
}

TEST(DeformingScene, ThatStandsHasEqualPosesAndNoMotion) {
  Scene s = movingRoom();
  setBending(s, "card", 0.5f, 1);
  const auto scene = ready(std::move(s));
  const PosedScene now = posedAt(scene, 3s), before = posedAt(scene, 2s), other = posedAt(scene, 900ms);
  EXPECT_TRUE(now.posesEqual(before));
  EXPECT_EQ(now.state(), before.state());
  EXPECT_FALSE(now.posesEqual(other));
  EXPECT_NE(now.state(), other.state());
  EXPECT_FALSE(MovedBodies(now, before).any());
  const Frame frame = render(now, before);
  const ImageF none(kSize, kSize);
  EXPECT_EQ(meanDifference(frame.g.motion_x, none), 0);
  EXPECT_EQ(meanDifference(frame.g.motion_y, none), 0);
}

TEST(DeformingScene, KeepsTheFormsThatItIsToldTo) {
  Scene s = movingRoom();
  setBending(s, "card", 0.5f, 1);
  const std::string names[]{"card"};
  keepForms(s, names);
  const auto scene = ready(std::move(s));
  EXPECT_TRUE(posedAt(scene, 1s).posesEqual(posedAt(scene, 0s)));
  EXPECT_EQ(posedAt(scene, 1s).deformed(), nullptr);
}

TEST(DeformingScene, DependsOnItsTimeAlone) {
  Scene s = movingRoom();
  setBending(s, "card", 0.5f, 1);
  const auto scene = ready(std::move(s));
  PosedScene posed = posedAt(scene, 1s);
  posed.setTime(0s), posed.setTime(400ms);
  const PosedScene fresh = posedAt(scene, 400ms);
  EXPECT_EQ(posed.state(), fresh.state());
  EXPECT_EQ(meanDifference(render(posed, posed).samples.I2, render(fresh, fresh).samples.I2), 0);
}

TEST(DeformingScene, LiesInTheBoxesOfBothTimes) {
  Scene s = movingRoom();
  setBending(s, "card", 0.5f, 1);
  const std::vector<Vec3> rest = meshOf(s, "card").positions;
  const auto scene = ready(std::move(s));
  const MovedBodies moved(posedAt(scene, 1s), posedAt(scene, 0s));
  ASSERT_EQ(moved.boxes().size(), 1u);
  const ShapeBox box = moved.boxes()[0];
  for (std::size_t i = 0; i + 1 < rest.size(); ++i)
    for (const Vec3 p : {rest[i], rest[i] + Vec3{0, 0, 0.5f * rest[i].x}})
      EXPECT_TRUE(p.x >= box.low.x && p.y >= box.low.y && p.z >= box.low.z && p.x <= box.high.x &&
                  p.y <= box.high.y && p.z <= box.high.z);
}

// A feed keeps a tree at each of two times. server/app/request counts as much for each of its triangles.
TEST(DeformingScene, TakesNoMoreMemoryThanIsCounted) {
  constexpr std::uint32_t kEdge = 100;
  constexpr double kCounted = 300, kTriangles = 2 * (kEdge - 1) * (kEdge - 1);
  Scene s = furnace(0.6f, 0);
  Mesh& mesh = s.meshes.emplace_back();
  mesh.name = "grid";
  for (std::uint32_t i = 0; i < kEdge * kEdge; ++i) {
    mesh.positions.push_back({static_cast<float>(i % kEdge), static_cast<float>(i / kEdge), 0});
    if (i % kEdge + 1 == kEdge || i / kEdge + 1 == kEdge) continue;
    mesh.triangles.push_back({i, i + 1, i + kEdge});
    mesh.triangles.push_back({i + 1, i + kEdge + 1, i + kEdge});
  }
  mesh.positions.push_back({});  // the spare one
  setBending(s, "grid", 0.5f, 1);
  const auto scene = ready(std::move(s));
  const std::size_t before = scene->bytes();
  const PosedScene posed = posedAt(scene, 1s);
  EXPECT_LT(static_cast<double>(scene->bytes() - before), kCounted * kTriangles);
}

// A surface keeps its place in caches of light while its mesh bends.
TEST(DeformingScene, HasItsCachePlacesWhereItRests) {
  Scene s = movingRoom();
  setBending(s, "card", 0.5f, 1);
  const auto scene = ready(std::move(s));
  const PosedScene first = posedAt(scene, 0s), bent = posedAt(scene, 1s);
  const std::uint32_t card = static_cast<std::uint32_t>(scene->description().meshes.size() - 1);
  const ShapePoint on{0, card, 1, 0.3f, 0.2f};
  const Mesh& rest = scene->description().meshes[card];
  const auto corners = rest.triangles[1];
  const auto at = [&](const Mesh& mesh) {
    return mesh.positions[corners[0]] * 0.5f + mesh.positions[corners[1]] * 0.3f +
           mesh.positions[corners[2]] * 0.2f;
  };
  const Vec3 point = at(bent.mesh(card));
  EXPECT_GT(length(point - at(rest)), 0.05f);
  EXPECT_LT(length(bent.carried(on, point, first) - at(rest)), 1e-6f);
  const Vec3 place = first.bodies()->cachePlace(on, at(rest));
  EXPECT_LT(length(bent.bodies()->cachePlace(on, point) - place), 1e-5f);
}

}  // namespace
}  // namespace saccade
