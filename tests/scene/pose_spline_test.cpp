#include "scene/camera/pose_spline.h"

#include <cmath>

#include "scene/scratch.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;

Trajectory cubic(std::vector<TimedPose> keys) {
  return Trajectory(std::move(keys), Interpolation::kCubic);
}

Quaternion rounded(Quaternion q) {
  return {q.x, q.y, q.z, q.w * (1 + 1e-15)};
}

// Turns every way, at uneven times. The quaternions are of unit length but for rounding.
std::vector<TimedPose> wildKeys() {
  return {{0ms, {{0, 0, 0}, axisAngle({0, 0, 0})}},
          {70ms, {{1, 2, -1}, rounded(axisAngle({0.8, -0.3, 0.5}))}},
          {100ms, {{2, 1, 0}, axisAngle({0.2, 1.1, -0.4})}},
          {240ms, {{-1, 1, 3}, rounded(axisAngle({-0.9, 0.6, 0.7}))}},
          {300ms, {{0, 4, 1}, axisAngle({0.1, 0.2, 2.0})}}};
}

Vec3d turnedBy(const Pose& a, const Pose& b) {
  return rotationVector(conjugate(a.rotation) * b.rotation);
}

TEST(PoseSpline, GoesThroughItsKeysBitForBitAndHoldsItsEnds) {
  const Trajectory path = cubic(wildKeys());
  for (const TimedPose& key : wildKeys()) EXPECT_EQ(path.at(key.time), key.pose);
  EXPECT_EQ(path.at(-1h), wildKeys().front().pose);
  EXPECT_EQ(path.at(1h), wildKeys().back().pose);
}

TEST(PoseSpline, BetweenTwoKeysItIsTheStraightWayAtConstantSpeed) {
  const Pose a{{1, 2, 3}, axisAngle({0.1, 0.2, 0.3})}, turn{{}, axisAngle({0.3, -0.5, 0.4})};
  const Pose b{{2, 2, 5}, a.rotation * turn.rotation};
  const Trajectory path = cubic({{0ms, a}, {1s, b}});
  expectNear(path.at(250ms).position, {1.25, 2, 3.5}, 1e-14);
  expectNear(turnedBy(a, path.at(250ms)), {0.075, -0.125, 0.1}, 1e-14);
}

// The slopes at inner keys are those of a parabola, which is then found again between them.
TEST(PoseSpline, FindsAParabolaAgainFromUnevenKeys) {
  const auto position = [](double t) { return Vec3d{3 * t * t - t, 2 - t * t, 0.5 * t}; };
  const auto turn = [](double t) { return Vec3d{0.36, 0.48, 0.8} * (0.3 * t + 0.4 * t * t); };
  std::vector<TimedPose> keys;
  for (const TimeNs t : {0ms, 300ms, 400ms, 1000ms, 1150ms, 1500ms})
    keys.push_back({t, {position(seconds(t)), axisAngle(turn(seconds(t)))}});
  const Trajectory path = cubic(keys);
  for (TimeNs t = 300ms; t < 1150ms; t += 17ms) {
    expectNear(path.at(t).position, position(seconds(t)), 1e-12);
    expectNear(rotationVector(path.at(t).rotation), turn(seconds(t)), 1e-12);
  }
}

TEST(PoseSpline, HasNoJumpOfVelocityAtAnyKey) {
  constexpr TimeNs kStep = 1us;
  const Trajectory path = cubic(wildKeys());
  for (const TimeNs key : {70ms, 100ms, 240ms}) {
    const Pose before = path.at(key - kStep), at = path.at(key), after = path.at(key + kStep);
    // Velocities are about 20 per second: halves that agree within a thousandth belong to one.
    expectNear((at.position - before.position) / 1e-6, (after.position - at.position) / 1e-6, 0.02);
    expectNear(turnedBy(before, at) / 1e-6, turnedBy(at, after) / 1e-6, 0.02);
    EXPECT_GT(length(after.position - at.position) / 1e-6, 5);
    EXPECT_GT(length(turnedBy(at, after)) / 1e-6, 1);
  }
}

TEST(PoseSpline, AStandingStretchStandsExactlyAndIsEnteredWithoutAJump) {
  std::vector<TimedPose> keys = wildKeys();
  keys[2].pose = keys[1].pose;
  const Trajectory path = cubic(keys);
  for (TimeNs t = 70ms; t <= 100ms; t += 1ms) EXPECT_EQ(path.at(t), keys[1].pose);
  for (const TimeNs outside : {70ms - 1us, 100ms + 1us}) {
    EXPECT_NE(path.at(outside), keys[1].pose);
    EXPECT_LT(length(path.at(outside).position - keys[1].pose.position) / 1e-6, 0.01);
    EXPECT_LT(length(turnedBy(path.at(outside), keys[1].pose)) / 1e-6, 0.01);
  }
}

TEST(PoseSpline, PositionAndRotationMayStandWithoutEachOther) {
  std::vector<TimedPose> keys = wildKeys();
  keys[2].pose.position = keys[1].pose.position;
  keys[4].pose.rotation = keys[3].pose.rotation;
  const Trajectory path = cubic(keys);
  for (TimeNs t = 71ms; t < 100ms; t += 1ms) {
    EXPECT_EQ(path.at(t).position, keys[1].pose.position);
    EXPECT_NE(path.at(t).rotation, keys[1].pose.rotation);
  }
  for (TimeNs t = 241ms; t < 300ms; t += 1ms) {
    EXPECT_EQ(path.at(t).rotation, keys[3].pose.rotation);
    EXPECT_NE(path.at(t).position, keys[3].pose.position);
  }
}

}  // namespace
}  // namespace saccade
