// Feeds of scenes in which bodies move, against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
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

// No pixel keeps the change longer than the frame in which the body is elsewhere.
TEST(MovingFeed, ChangesForOneFrameWhenABodyJumps) {
  const Scene s = withBody(cardUnderALamp(0.5f), "card");
  const Vec3d start = toDouble(s.bodies[0].centre());
  const auto at = [](FrameIndex t) { return frameTime(t, kRate); };
  const Trajectory jump(
      {{at(0), {start, {}}}, {at(3), {start, {}}}, {at(4), {start + Vec3d{0.4, 0, 0}, {}}}});
  TilePool pool(2);
  Feed feed(std::make_shared<RenderScene>(s), standing(s), config("irradiance_cache", s, {jump}), pool);
  for (int t = 1; t < 8; ++t) {
    const double most = largest(feed.step(pool).dI);
    EXPECT_EQ(most > 0, t == 4) << t;
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
class MovingFeedOf : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(, MovingFeedOf, testing::ValuesIn(kMethods), [](const auto& info) {
  std::string name = info.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

TEST_P(MovingFeedOf, SharesItsSceneWithOthers) {
  const Scene s = withBody(cardUnderALamp(0.5f), "card");
  const auto scene = std::make_shared<RenderScene>(s);
  TilePool pool(2);
  const auto make = [&](double step) {
    return std::make_unique<Feed>(scene, standing(s), config(GetParam(), s, {along(s.bodies[0], step, 5)}),
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
