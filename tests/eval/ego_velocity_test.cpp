#include "eval/tasks/ego_velocity.h"

#include <gtest/gtest.h>

#include <random>

#include "eval/task_truths.h"
#include "eval/tasks/task.h"

namespace saccade::eval {
namespace {

constexpr int kWidth = 64, kHeight = 48;
const Vec3d kGoes{0.4, -0.3, 1.2}, kTurns{0.2, -0.5, 0.3};

// Where a point of the camera's space is seen.
Vec2 seenAt(Vec3d p, const CameraModel& camera) {
  return {static_cast<float>(camera.cx + camera.fx * p.x / p.z),
          static_cast<float>(camera.cy + camera.fy * p.y / p.z)};
}

// Edges at random places and depths of 2 to 5, in random directions. Each moves as points do that a camera
// with these velocities passes by: P' = -v - w x P, by differences of places.
std::vector<EdgeFlow> edgesOf(int count, const CameraModel& camera) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(0, 1);
  std::vector<EdgeFlow> edges;
  for (int i = 0; i < count; ++i) {
    const double z = 2 + 3 * u(random);
    const Vec3d p{(u(random) * kWidth - camera.cx) / camera.fx * z,
                  (u(random) * kHeight - camera.cy) / camera.fy * z, z};
    constexpr double kStep = 1e-3;
    const Vec3d step = (-kGoes - cross(kTurns, p)) * kStep;
    const Vec2 before = seenAt(p - step, camera), after = seenAt(p + step, camera), at = seenAt(p, camera);
    const double angle = 6.283 * u(random);
    const double across =
        ((after.x - before.x) * std::cos(angle) + (after.y - before.y) * std::sin(angle)) / (2 * kStep);
    edges.push_back(
        {at,
         {static_cast<float>(across * std::cos(angle)), static_cast<float>(across * std::sin(angle))},
         static_cast<float>(z)});
  }
  return edges;
}

TEST(EgoVelocity, IsThatOfTheCamera) {
  const CameraModel camera = pinhole(60, kWidth, kHeight);
  const auto v = egoVelocity(edgesOf(50, camera), camera, kTurns);
  ASSERT_TRUE(v);
  EXPECT_LT(length(*v - kGoes), 0.01);
}

TEST(EgoVelocity, HeedsNoEdgeInFiveThatLies) {
  const CameraModel camera = pinhole(60, kWidth, kHeight);
  std::vector<EdgeFlow> edges = edgesOf(100, camera);
  for (std::size_t i = 0; i < edges.size(); i += 5) edges[i].flow.x += 30;
  const auto v = egoVelocity(edges, camera, kTurns);
  ASSERT_TRUE(v);
  EXPECT_LT(length(*v - kGoes), 0.02);
}

TEST(EgoVelocity, IsOpenWithFewEdgesOrOneDirection) {
  const CameraModel camera = pinhole(60, kWidth, kHeight);
  EXPECT_FALSE(egoVelocity(edgesOf(kLeastEdges - 1, camera), camera, kTurns));
  std::vector<EdgeFlow> edges(50, edgesOf(1, camera).front());
  EXPECT_FALSE(egoVelocity(edges, camera, kTurns));
}

// Edges go over a wall at depth 2 by 100 pixels per second. In the upper half of the picture they are upright
// and go to the right. In the lower half they are level and go down. So the camera goes left and up, by
// 2 * 100 / f.
TEST(EgoVelocity, IsScoredAgainstTheCamera) {
  constexpr double kSpeed = 100;
  Events events;
  for (std::uint16_t y = 0; y < kHeight; ++y)
    for (std::uint16_t x = 0; x < kWidth; ++x) {
      const int at = (y < kHeight / 2 ? x : y) % 8;
      events.push_back({static_cast<std::int64_t>(1e9 * at / kSpeed), x, y, 1});
    }
  std::stable_sort(events.begin(), events.end(), [](Event a, Event b) { return a.t_ns < b.t_ns; });
  TaskTruth truth = test::steadyTruth(kWidth, kHeight, 16, {float(kSpeed), float(kSpeed)});
  EXPECT_FALSE(truth.goes());
  const double away = -2 * kSpeed;
  for (TruthFrame& frame : truth.frames) {
    frame.z.fill(2);
    frame.camera.linear = {away / truth.camera.fx, away / truth.camera.fy, 0};
  }
  EXPECT_TRUE(truth.goes());
  const TaskScore score = scoreEgoVelocity({events, {}, 0.2, 1e-3, truth});
  EXPECT_LT(score.error, 0.01);
  EXPECT_EQ(score.answers, 2u);
  for (TruthFrame& frame : truth.frames) frame.camera.linear = frame.camera.linear * 2.0;
  EXPECT_NEAR(scoreEgoVelocity({events, {}, 0.2, 1e-3, truth}).error, 0.5, 0.01);
  EXPECT_TRUE(std::isnan(scoreEgoVelocity({{}, {}, 0.2, 1e-3, truth}).error));
}

}  // namespace
}  // namespace saccade::eval
