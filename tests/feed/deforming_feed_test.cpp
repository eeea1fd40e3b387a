// Feeds of scenes whose meshes deform, against bodies that move in the same way.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "feed/feed.h"
#include "render/deforming_shapes.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

constexpr int kSize = 32;
constexpr double kRate = 100, kStep = 0.02;

FeedConfig config(const std::string& method, const Scene& scene, const Trajectory& path) {
  FeedConfig c;
  c.camera = pinhole(scene.fov_x_deg, kSize, kSize), c.frame_rate_hz = kRate, c.bounces = 1;
  c.method = method, c.body_paths = {path};
  std::string name;
  EXPECT_EQ(resolveParams(*findMethod(c.method), {}, c.params, name), "");
  return c;
}

// A floor under a lamp, with a card between them, whose shadow the camera sees beside it.
Scene room() {
  Scene s = test::floorFromAbove(0.5f);
  s.meshes.push_back(test::quad({0.55f, -0.25f, 2}, {0, 0.5f, 0}, {0.5f, 0, 0}, 0, {60, 60, 60}));
  s.meshes.push_back(test::quad({0, -2, 0.5f}, {2, 0, 0}, {0, 4, 0}, 0));
  s.meshes.back().name = "card";
  s.T_world_camera = {{0.3, 0, 1.9}, {1, 0, 0, 0}};
  s.fov_x_deg = 60;
  return s;
}

// The card goes along x for a second: as a body, or by its vertices.
Scene withBody() {
  Scene s = room();
  const std::string names[]{"card"};
  setBodies(s, names);
  return s;
}
Scene withVertices() {
  Scene s = room();
  test::setNodeMotion(s, "card", {{kStep * kRate, 0, 0}, {}}, 1);
  return s;
}

Trajectory pathOf(const Scene& s, double speed) {
  const Vec3d start = toDouble(s.bodies[0].centre());
  return Trajectory({{TimeNs(0), {start, {}}}, {std::chrono::seconds(1), {start + Vec3d{speed, 0, 0}, {}}}});
}

Trajectory camera(const Scene& s) {
  return Trajectory({{TimeNs(0), s.T_world_camera}});
}

double sum(const ImageF& plane, const auto& of) {
  double all = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) all += of(plane.at(x, y), x, y);
  return all;
}

// Both feeds have the same change, up to the rounding of vertices: paths end otherwise in few pixels.
TEST(DeformingFeed, ThatMovesAsABodyChangesAsIt) {
  const Scene as_body = withBody(), as_vertices = withVertices();
  for (const std::string method : {"irradiance_cache", "event_svgf", "svgf"}) {
    TilePool pool(2);
    Feed body(std::make_shared<RenderScene>(as_body), camera(as_body),
              config(method, as_body, pathOf(as_body, kStep * kRate)), pool);
    Feed vertices(std::make_shared<RenderScene>(as_vertices), camera(as_vertices),
                  config(method, as_vertices, pathOf(as_vertices, 0)), pool);
    for (int t = 1; t < 8; ++t) {
      const ImageF &a = body.step(pool).dI, &b = vertices.step(pool).dI;
      const double whole = sum(a, [](float v, int, int) { return std::abs(v); });
      const double apart = sum(a, [&](float v, int x, int y) { return std::abs(v - b.at(x, y)); });
      EXPECT_GT(whole, 1) << method;
      EXPECT_LT(apart, 0.15 * whole) << method << " " << t;
    }
  }
}

TEST(DeformingFeed, HasNoChangeOnceItsFormStands) {
  Scene s = room();
  test::setBending(s, "card", 0.2f, 0.05f);
  TilePool pool(2);
  Feed feed(std::make_shared<RenderScene>(s), camera(s), config("irradiance_cache", s, pathOf(s, 0)), pool);
  const auto change = [&] { return sum(feed.step(pool).dI, [](float v, int, int) { return std::abs(v); }); };
  for (int t = 1; t <= 5; ++t) EXPECT_GT(change(), 0) << t;
  for (int t = 6; t <= 8; ++t) EXPECT_EQ(change(), 0) << t;
}

TEST(DeformingFeed, IsTheSameForAnyNumberOfThreads) {
  Scene s = room();
  test::setBending(s, "card", 0.2f, 0.05f);
  const auto scene = std::make_shared<RenderScene>(s);
  std::vector<ImageF> changes;
  for (const int threads : {1, 5}) {
    TilePool pool(threads);
    Feed feed(scene, camera(s), config("irradiance_cache", s, pathOf(s, 0)), pool);
    feed.step(pool);
    changes.emplace_back(kSize, kSize).copyFrom(feed.step(pool).dI);
  }
  EXPECT_EQ(sum(changes[0], [&](float v, int x, int y) { return v != changes[1].at(x, y); }), 0);
}

}  // namespace
}  // namespace saccade
