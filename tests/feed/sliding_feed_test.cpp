// Feeds of floors that slide or turn in themselves, against closed forms.
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
constexpr double kPixel = 2 * 0.57735 / kSize;  // of a camera at height 1, with 60 degrees

Scene floor(SurfaceColor::Kind texture) {
  Scene s = test::floorFromAbove(1);
  s.meshes[0].name = "floor";
  s.materials[0].reflectance = {
      .kind = texture, .color0 = {0.2f, 0.2f, 0.2f}, .color1 = {0.8f, 0.8f, 0.8f}, .uv_scale = {5, 5}};
  s.T_world_camera.position = {0, 0, 1};
  s.fov_x_deg = 60;
  const std::string names[]{"floor"};
  setBodies(s, names);
  return s;
}

Scene inTheSun(Scene s) {
  s.directional_lights = {{{0, 0, -1}, {3, 3, 3}}};
  return s;
}

// With a lamp, a wall that gives indirect light, and a card in the way of the lamp; the camera sees none.
Scene inARoom(Scene s) {
  s.meshes.push_back(test::quad({-0.3f, -0.3f, 2}, {0, 0.6f, 0}, {0.6f, 0, 0}, 0, {60, 60, 60}));
  s.meshes.push_back(test::quad({1, -2, 0}, {0, 4, 0}, {0, 0, 2}, 0));
  s.meshes.push_back(test::quad({0, -2, 1.2f}, {2, 0, 0}, {0, 4, 0}, 0));
  return s;
}

struct Place {
  double x, y;
};

// The motion of the floor in each frame: along x, and about the middle of the picture.
struct Step {
  double along, turn;

  Trajectory path() const {
    std::vector<TimedPose> keys;
    for (FrameIndex t = 0; t < 20; ++t) {
      const double n = static_cast<double>(t);
      keys.push_back({frameTime(t, kRate), {{along * n, 0, 0}, axisAngle({0, 0, turn * n})}});
    }
    return Trajectory(keys);
  }
  // Where on the floor a place lies in frame t.
  Place rest(Place at, double t) const {
    const double x = at.x - along * t, c = std::cos(turn * t), s = std::sin(turn * t);
    return {c * x + s * at.y, c * at.y - s * x};
  }
};

FeedConfig config(const Scene& scene, const Step& step, int bounces) {
  FeedConfig c;
  c.camera = pinhole(scene.fov_x_deg, kSize, kSize), c.frame_rate_hz = kRate, c.bounces = bounces;
  c.body_paths = {step.path()};
  std::string name;
  EXPECT_EQ(resolveParams(*findMethod(c.method), {}, c.params, name), "");
  return c;
}

class SlidingFeed : public testing::TestWithParam<Step> {};
INSTANTIATE_TEST_SUITE_P(, SlidingFeed, testing::Values(Step{0.2, 0}, Step{0, 0.3}),
                         [](const auto& info) { return info.param.turn > 0 ? "Turns" : "Slides"; });

TEST_P(SlidingFeed, InTheSunItChangesAsItsTexture) {
  const Scene s = inTheSun(floor(SurfaceColor::Kind::kCheckerboard));
  TilePool pool(2);
  Feed feed(std::make_shared<RenderScene>(s), Trajectory({{TimeNs(0), s.T_world_camera}}),
            config(s, GetParam(), 0), pool);
  feed.step(pool);
  const IntensityChange& change = feed.step(pool);
  // Squares of edge 1; where no edge is nearer than two pixels.
  const auto isInside = [](Place p) {
    const auto fromEdge = [](double v) { return std::abs(v - std::round(v)); };
    return std::min(fromEdge(p.x), fromEdge(p.y)) > 2 * kPixel;
  };
  const auto lightAt = [](Place p) {
    const auto square = [](double v) { return static_cast<int>(std::floor(v)) & 1; };
    return (square(p.x) == square(p.y) ? 0.2 : 0.8) * 3 / std::numbers::pi;
  };
  int changed = 0;
  double sign = 0;  // which of the two colours comes first
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const Place at{(x + 0.5 - kSize / 2.) * kPixel, -(y + 0.5 - kSize / 2.) * kPixel};
      const Place now = GetParam().rest(at, 2), before = GetParam().rest(at, 1);
      if (!isInside(now) || !isInside(before)) continue;
      const double expected = lightAt(now) - lightAt(before), dI = change.dI.at(x, y);
      if (sign == 0 && expected != 0) sign = dI / expected > 0 ? 1 : -1;
      EXPECT_NEAR(dI, sign * expected, 2e-5) << x << ' ' << y;  // what the texture's filter rounds
      changed += expected != 0;
    }
  EXPECT_GT(changed, 5);
}

TEST_P(SlidingFeed, OfOneColourInTheSunHasNoChange) {
  const Scene s = inTheSun(floor(SurfaceColor::Kind::kConstant));
  TilePool pool(2);
  Feed feed(std::make_shared<RenderScene>(s), Trajectory({{TimeNs(0), s.T_world_camera}}),
            config(s, GetParam(), 0), pool);
  for (int t = 1; t < 6; ++t) {
    const IntensityChange& change = feed.step(pool);
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) EXPECT_LT(std::abs(change.dI.at(x, y)), 1e-6) << t;
  }
}

double meanOf(const ImageF& plane) {
  double sum = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) sum += plane.at(x, y);
  return sum / (kSize * kSize);
}

// But for the rounding of where rays meet the floor.
TEST_P(SlidingFeed, OfOneColourInARoomHasNoChange) {
  const Scene s = inARoom(floor(SurfaceColor::Kind::kConstant));
  TilePool pool(2);
  Feed feed(std::make_shared<RenderScene>(s), Trajectory({{TimeNs(0), s.T_world_camera}}),
            config(s, GetParam(), 2), pool);
  feed.step(pool);  // the floor has not moved before
  for (int t = 2; t < 8; ++t) {
    const IntensityChange& change = feed.step(pool);
    const double most = 1e-4 * meanOf(change.I_now);
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x)
        EXPECT_LE(std::abs(change.dI.at(x, y)), most) << t << ' ' << x << ' ' << y;
  }
}

// About an axis far above, by 0.002 in each frame: light changes by as little.
TEST(TurningWall, DoesNotShadeItself) {
  const Scene s = inARoom(floor(SurfaceColor::Kind::kConstant));
  constexpr double kFar = 5;
  std::vector<TimedPose> keys;
  for (FrameIndex t = 0; t < 8; ++t) {
    const double turn = 0.002 * static_cast<double>(t);
    keys.push_back({frameTime(t, kRate),
                    {{0, kFar * std::sin(turn), kFar - kFar * std::cos(turn)}, axisAngle({turn, 0, 0})}});
  }
  FeedConfig c = config(s, {}, 2);
  c.body_paths = {Trajectory(keys)};
  TilePool pool(2);
  Feed feed(std::make_shared<RenderScene>(s), Trajectory({{TimeNs(0), s.T_world_camera}}), c, pool);
  for (int t = 1; t < 8; ++t) {
    const IntensityChange& change = feed.step(pool);
    int changed = 0;
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) changed += std::abs(change.dI.at(x, y)) > 0.1 * change.I_now.at(x, y);
    EXPECT_LE(changed, 5) << t;  // noise where it is dark
  }
}

}  // namespace
}  // namespace saccade
