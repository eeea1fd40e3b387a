// Feeds of scenes in which bodies move, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "feed/feed.h"
#include "render/test_scenes.h"
#include "scene/motion/bodies.h"

namespace saccade {
namespace {

constexpr int kSize = 32;
constexpr double kRate = 100;

FeedConfig config(const std::string& method, const Scene& scene, std::vector<Trajectory> paths) {
  FeedConfig c;
  c.camera = pinhole(scene.fov_x_deg, kSize, kSize), c.frame_rate_hz = kRate, c.bounces = 1;
  c.method = method, c.body_paths = std::move(paths);
  std::string name;
  EXPECT_EQ(resolveParams(*findMethod(c.method), {}, c.params, name), "");
  return c;
}

Trajectory standing(const Scene& scene) {
  return Trajectory({{TimeNs(0), scene.T_world_camera}});
}

// Goes along x by so much in each of `frames` frames, and stands from then on.
Trajectory along(const Body& body, double step, int frames) {
  const Vec3d start = toDouble(body.centre());
  const TimeNs end = frameTime(static_cast<FrameIndex>(frames), kRate);
  return Trajectory({{TimeNs(0), {start, {}}}, {end, {start + Vec3d{step * frames, 0, 0}, {}}}});
}

Scene withBody(Scene s, const std::string& name) {
  const std::string names[]{name};
  setBodies(s, names);
  return s;
}

// A floor under a lamp, with a card between them.
Scene cardUnderALamp(float lamp_edge) {
  Scene s = test::floorFromAbove(0.5f);
  const float half = lamp_edge / 2;
  s.meshes.push_back(test::quad({-half, -half, 2}, {0, lamp_edge, 0}, {lamp_edge, 0, 0}, 0, {60, 60, 60}));
  s.meshes.push_back(test::quad({0, -2, 1}, {2, 0, 0}, {0, 4, 0}, 0));
  s.meshes.back().name = "card";
  s.T_world_camera = {{0.3, 0, 0.9}, {1, 0, 0, 0}};
  s.fov_x_deg = 60;
  return s;
}

double largest(const ImageF& plane) {
  double most = 0;
  for (int y = 0; y < plane.height(); ++y)
    for (int x = 0; x < plane.width(); ++x) most = std::max(most, std::abs(double(plane.at(x, y))));
  return most;
}

const std::vector<std::string> kMethods{"irradiance_cache", "event_svgf", "svgf", "pt-correlated"};

TEST(MovingFeed, OfABodyThatStandsHasNoChange) {
  const Scene s = withBody(cardUnderALamp(0.5f), "card");
  TilePool pool(2);
  for (const std::string method : {"irradiance_cache", "event_svgf"}) {
    Feed feed(std::make_shared<RenderScene>(s), standing(s), config(method, s, {along(s.bodies[0], 0, 9)}),
              pool);
    for (int t = 1; t < 6; ++t) EXPECT_EQ(largest(feed.step(pool).dI), 0) << method << t;
  }
}

TEST(MovingFeed, HasNoChangeOnceItsBodyHasStopped) {
  const Scene s = withBody(cardUnderALamp(0.5f), "card");
  TilePool pool(2);
  Feed feed(std::make_shared<RenderScene>(s), standing(s),
            config("irradiance_cache", s, {along(s.bodies[0], 0.03, 5)}), pool);
  for (int t = 1; t <= 5; ++t) EXPECT_GT(largest(feed.step(pool).dI), 0) << t;
  for (int t = 6; t < 10; ++t) EXPECT_EQ(largest(feed.step(pool).dI), 0) << t;
}

// An edge at height h stands under a square lamp of edge s at height H. In its penumbra the share of the lamp
// that is seen falls linearly over s h / (H - h). So it changes by v (H / (H - h)) / (s h / (H - h)), which
// is v H / (s h), in each frame.
TEST(MovingFeed, ThePenumbraOfAMovingEdgeChangesAsItsGeometrySays) {
  constexpr double kH = 2, kh = 1, kLamp = 0.5, kStep = 0.01;
  const Scene s = withBody(cardUnderALamp(kLamp), "card");
  TilePool pool(2);
  FeedConfig c = config("irradiance_cache", s, {along(s.bodies[0], kStep, 100)});
  c.bounces = 0;
  Feed feed(std::make_shared<RenderScene>(s), standing(s), c, pool);
  for (int t = 1; t < 20; ++t) feed.step(pool);
  const IntensityChange& change = feed.step(pool);
  const double pixel = 2 * 0.9 * std::tan(std::numbers::pi / 6) / kSize;
  double inside = 0, expected = 0, outside = 0;
  for (int y = 8; y < kSize - 8; ++y)
    for (int x = 0; x < kSize; ++x) {
      const double at = 0.3 + (x + 0.5 - kSize / 2.) * pixel;  // on the floor
      const double edge = 2 * (kStep * 19.5);                  // of its shadow, in the middle
      const double from = at - edge, half = kLamp * kh / (kH - kh) / 2;
      const double V = 0.5 - from / (2 * half), I = change.I_now.at(x, y);
      if (std::abs(V - 0.5) < 0.4) {
        inside += change.dI.at(x, y);
        expected += I / (V + kStep * kH / (kLamp * kh) / 2) * kStep * kH / (kLamp * kh);
      } else if (std::abs(V - 0.5) > 0.7) {
        outside = std::max(outside, std::abs(double(change.dI.at(x, y))) / std::max(I, 0.1));
      }
    }
  EXPECT_NEAR(inside / expected, 1, 0.15);
  EXPECT_LT(outside, 0.02);
}

// A textured floor that slides in itself in the sun: the change is that of its texture.
TEST(MovingFeed, ASlidingFloorChangesAsItsTexture) {
  Scene s = test::floorFromAbove(1);
  s.meshes[0].name = "floor";
  s.directional_lights = {{{0, 0, -1}, {3, 3, 3}}};
  s.materials[0].reflectance = {.kind = SurfaceColor::Kind::kCheckerboard,
                                .color0 = {0.2f, 0.2f, 0.2f},
                                .color1 = {0.8f, 0.8f, 0.8f},
                                .uv_scale = {5, 5}};
  s.T_world_camera.position = {0, 0, 1};
  s.fov_x_deg = 60;
  s = withBody(std::move(s), "floor");
  TilePool pool(2);
  constexpr double kStep = 0.1;
  FeedConfig c = config("irradiance_cache", s, {along(s.bodies[0], kStep, 100)});
  c.bounces = 0;
  Feed feed(std::make_shared<RenderScene>(s), standing(s), c, pool);
  feed.step(pool);
  const IntensityChange& change = feed.step(pool);
  const double pixel = 2 * std::tan(std::numbers::pi / 6) / kSize;
  const auto lightAt = [&](double x, double y, double shift) {
    const auto cell = [](double v) { return static_cast<int>(std::floor(v)); };
    const bool odd = ((cell((x - shift + 5) / 10 * 5 * 2) + cell((y + 5) / 10 * 5 * 2)) & 1) != 0;
    return (odd ? 0.8 : 0.2) * 3 / std::numbers::pi;
  };
  int checked = 0, changed = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const double px = (x + 0.5 - kSize / 2.) * pixel, py = -(y + 0.5 - kSize / 2.) * pixel;
      const double expected = lightAt(px, py, 2 * kStep) - lightAt(px, py, kStep);
      checked += std::abs(std::abs(change.dI.at(x, y)) - std::abs(expected)) < 0.02;
      changed += std::abs(expected) > 0.1;
    }
  EXPECT_GT(changed, 50);
  EXPECT_GT(checked, kSize * kSize * 0.85);  // but at edges, which the filter of the texture smooths
}

TEST(MovingFeed, IsTheSameForAnyNumberOfThreads) {
  const Scene s = withBody(cardUnderALamp(0.5f), "card");
  const auto scene = std::make_shared<RenderScene>(s);
  for (const std::string& method : kMethods) {
    std::vector<ImageF> changes;
    for (const int threads : {1, 2, 5}) {
      TilePool pool(threads);
      Feed feed(scene, standing(s), config(method, s, {along(s.bodies[0], 0.03, 5)}), pool);
      feed.step(pool);
      changes.emplace_back(kSize, kSize).copyFrom(feed.step(pool).dI);
    }
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        ASSERT_EQ(changes[0].at(x, y), changes[1].at(x, y)) << method;
        ASSERT_EQ(changes[0].at(x, y), changes[2].at(x, y)) << method;
      }
  }
}

// Two feeds of one scene at different times do not disturb each other.
TEST(MovingFeed, SharesItsSceneWithOthers) {
  const Scene s = withBody(cardUnderALamp(0.5f), "card");
  const auto scene = std::make_shared<RenderScene>(s);
  TilePool pool(2);
  const auto make = [&](double step) {
    return std::make_unique<Feed>(scene, standing(s), config("event_svgf", s, {along(s.bodies[0], step, 5)}),
                                  pool);
  };
  const auto alone = make(0.03), one = make(0.03), other = make(-0.1);
  for (int t = 1; t < 4; ++t) {
    other->step(pool);
    const IntensityChange &a = alone->step(pool), &b = one->step(pool);
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) ASSERT_EQ(a.dI.at(x, y), b.dI.at(x, y));
  }
}

}  // namespace
}  // namespace saccade
