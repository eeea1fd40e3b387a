// The reported speed of the picture against closed forms, on walls that fill the view.
#include "feed/pixel_speed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "feed/feed.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;

constexpr double kDepth = 4, kFov = 60;

// A wall that faces the camera, from x on to the right.
RenderScene wall(float x_from = -100) {
  Scene s;
  s.materials = {test::grey(0.5f)};
  s.meshes = {test::quad({x_from, -100, kDepth}, {200, 0, 0}, {0, 200, 0}, 0)};
  return RenderScene(std::move(s));
}

FeedConfig config(double frame_rate_hz = 500) {
  FeedConfig c;
  c.camera = pinhole(kFov, 200, 100), c.frame_rate_hz = frame_rate_hz;
  return c;
}

double focalPx() {
  return 200 / 2.0 / std::tan(kFov * std::numbers::pi / 360);
}

// A path that goes right by `speed` scene units per second for two seconds, then stands.
Trajectory truck(double speed) {
  return Trajectory({{0s, {}}, {2s, {{2 * speed, 0, 0}, {}}}});
}

Trajectory pan(double rad_per_s) {
  return Trajectory({{0s, {}}, {1s, {{}, axisAngle({0, rad_per_s, 0})}}});
}

TEST(PixelSpeed, OfATruckPastAWallIsFocalLengthTimesSpeedOverDepth) {
  for (const double rate : {100.0, 500.0}) {
    const PixelSpeed found = measurePixelSpeed(wall(), truck(-0.8), config(rate), 0);
    const double px = focalPx() * 0.8 / rate / kDepth;
    EXPECT_NEAR(found.p50, px, 1e-4 * px);
    EXPECT_NEAR(found.p99, px, 1e-4 * px);
  }
}

Trajectory stands(Vec3d at) {
  return Trajectory(std::vector<TimedPose>{{0s, {at, {}}}});
}

// A wall that is a body goes by: the camera stands, or goes with it.
TEST(PixelSpeed, OfABodyIsItsOwnMotionAgainstTheCamera) {
  Scene s;
  s.materials = {test::grey(0.5f)};
  s.meshes = {test::quad({-100, -100, kDepth}, {200, 0, 0}, {0, 200, 0}, 0)};
  s.meshes[0].body = 0;
  s.bodies = {{"wall", {-100, -100, kDepth}, {100, 100, kDepth}}};
  const RenderScene scene(std::move(s));
  FeedConfig c = config();
  c.body_paths = {Trajectory({{0s, {{0, 0, kDepth}, {}}}, {2s, {{1.6, 0, kDepth}, {}}}})};
  const double px = focalPx() * 0.8 / 500 / kDepth;
  const PixelSpeed alone = measurePixelSpeed(scene, stands({}), c, 0);
  EXPECT_NEAR(alone.p50, px, 1e-3 * px);
  EXPECT_NEAR(alone.p99, px, 1e-3 * px);
  EXPECT_NEAR(measurePixelSpeed(scene, truck(-0.8), c, 0).p50, 2 * px, 2e-3 * px);
  EXPECT_LT(measurePixelSpeed(scene, truck(0.8), c, 0).p99, 1e-3 * px);
  c.body_paths = {stands({0, 0, kDepth})};
  EXPECT_EQ(measurePixelSpeed(scene, stands({}), c, 0).p99, 0);
}

// The slowest pixels of a pan are in the middle, the fastest at the left and right. The speed is (1 + x^2)
// for the ray (x, 0, 1).
TEST(PixelSpeed, OfAPanGrowsTowardsTheEdges) {
  const PixelSpeed found = measurePixelSpeed(wall(), pan(0.1), config(), 50);
  const double middle = focalPx() * 0.1 / 500;
  EXPECT_GT(found.p50, middle);
  EXPECT_LT(found.p50, found.p99);
  EXPECT_LT(found.p99, 1.06 * middle * (1 + std::pow(std::tan(kFov * std::numbers::pi / 360), 2)));
  EXPECT_GT(found.p99, 1.2 * middle);
}

// An equidistant lens shows angles: along the horizon a pan moves everything alike.
TEST(PixelSpeed, OfAPanThroughAFisheyeIsTheSameAlongTheHorizon) {
  FeedConfig c = config();
  c.camera = {.width = 200,
              .height = 1,
              .fx = 100,
              .fy = 100,
              .cx = 99.5,
              .cy = 0,
              .distortion = {LensModel::kEquidistant, {}}};
  const PixelSpeed found = measurePixelSpeed(wall(), pan(0.1), c, 50);
  EXPECT_NEAR(found.p50, 100 * 0.1 / 500, 1e-5);
  EXPECT_NEAR(found.p99, 100 * 0.1 / 500, 1e-5);
}

TEST(PixelSpeed, CountsPixelsThatAreNotSquare) {
  FeedConfig c = config();
  c.camera.fx *= 3;
  const double px = 3 * focalPx() * 0.8 / 500 / kDepth;
  EXPECT_NEAR(measurePixelSpeed(wall(), truck(-0.8), c, 0).p50, px, 1e-4 * px);
}

TEST(PixelSpeed, IsThatOfSurfacesAlone) {
  const double px = focalPx() * 0.01 / 500 / kDepth;
  const PixelSpeed right_third = measurePixelSpeed(wall(0.8f), truck(0.01), config(), 10);
  EXPECT_NEAR(right_third.p50, px, 1e-4 * px);
  EXPECT_EQ(measurePixelSpeed(wall(50), truck(0.01), config(), 10).p99, 0);
}

TEST(PixelSpeed, IsThatOfTheFramesOfTheStream) {
  const Trajectory late({{0s, {}}, {1s, {}}, {2s, {{1, 0, 0}, {}}}});
  EXPECT_EQ(measurePixelSpeed(wall(), late, config(), 400).p99, 0);  // ends before it moves
  const PixelSpeed half_of_it = measurePixelSpeed(wall(), late, config(), 0);
  EXPECT_EQ(half_of_it.p50 * half_of_it.p99, 0);
  EXPECT_NEAR(half_of_it.p99, focalPx() / 500 / kDepth, 1e-3);
  // Frames after the end of the path do not count.
  EXPECT_NEAR(measurePixelSpeed(wall(), truck(1), config(), 1'000'000'000).p50, focalPx() / 500 / kDepth,
              1e-3);
}

TEST(PixelSpeed, OfWhatStandsIsExactlyZero) {
  const Pose home{{0.1, 0.2, 0.3}, axisAngle({0.1, 0.2, 0.3})};
  const PixelSpeed found = measurePixelSpeed(wall(), Trajectory({{0s, home}}), config(), 0);
  EXPECT_EQ(found.p50, 0);
  EXPECT_EQ(found.p99, 0);
}

}  // namespace
}  // namespace saccade
