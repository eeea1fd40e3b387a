// Velocities along a path, against closed forms and against differences of its poses.
#include <cmath>

#include "scene/camera/screw_motion.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;

std::vector<TimedPose> wildKeys() {
  return {{0ms, {{0, 0, 0}, axisAngle({0, 0, 0})}},
          {70ms, {{1, 2, -1}, axisAngle({0.8, -0.3, 0.5})}},
          {100ms, {{2, 1, 0}, axisAngle({0.2, 1.1, -0.4})}},
          {240ms, {{-1, 1, 3}, axisAngle({-0.9, 0.6, 0.7})}}};
}

// The error of the central difference is quadratic in its step: about 1e-6 of these speeds.
Velocity differenceAt(const Trajectory& path, TimeNs t) {
  constexpr TimeNs kStep = 10us;
  const Pose before = path.at(t - kStep), after = path.at(t + kStep);
  const double span_s = seconds(2 * kStep);
  return {(after.position - before.position) / span_s,
          rotationVector(conjugate(before.rotation) * after.rotation) / span_s};
}

TEST(PathVelocity, IsTheDerivativeOfThePoses) {
  for (const Interpolation kind : {Interpolation::kLinear, Interpolation::kCubic}) {
    const Trajectory path(wildKeys(), kind);
    for (TimeNs t = 1ms; t < 240ms; t += 6ms) {
      if (t == 70ms || t == 100ms) continue;
      const Velocity found = path.velocityAt(t), expected = differenceAt(path, t);
      expectNear(found.linear, expected.linear, 1e-3);
      expectNear(found.angular, expected.angular, 1e-3);
    }
  }
}

// An orbit to the right, about a point 2 ahead, at 3 radians per second.
TEST(PathVelocity, OfAScrewIsThatOfARigidBody) {
  const Screw screw{{{}, {0, -1, 0}}, {0, 0, 2}, 1};
  const Pose start{{1, 2, 3}, axisAngle({0.3, 0.8, -0.2})};
  const Trajectory path = onAndOn(screw, start, 3);
  for (const TimeNs t : {0ms, 100ms, 700ms, 1900ms, 2500ms}) {
    const Pose pose = path.at(t);
    const Velocity v = path.velocityAt(t);
    expectNear(v.angular, {0, -3, 0}, 1e-8);
    expectNear(v.linear, rotate(pose.rotation, cross(Vec3d{0, -3, 0}, Vec3d{0, 0, -2})), 1e-8);
  }
}

TEST(PathVelocity, AtAKeyIsThatOfTheWayThere) {
  const Pose a{{0, 0, 0}, {}}, b{{1, 0, 0}, {}};
  const Trajectory path({{0ms, a}, {100ms, b}, {200ms, a}});
  expectNear(path.velocityAt(0ms).linear, {10, 0, 0}, 1e-12);
  expectNear(path.velocityAt(100ms).linear, {10, 0, 0}, 1e-12);
  expectNear(path.velocityAt(100ms + 1ns).linear, {-10, 0, 0}, 1e-12);
  expectNear(path.velocityAt(200ms).linear, {-10, 0, 0}, 1e-12);
  EXPECT_EQ(path.velocityAt(200ms + 1ns), Velocity{});
  EXPECT_EQ(path.velocityAt(-1ns), Velocity{});
}

TEST(PathVelocity, OfAPeriodicPathIsThatBeforeItBeginsAgain) {
  const Pose a{{0, 0, 0}, {}}, b{{1, 0, 0}, {}};
  const Trajectory path = Trajectory::periodic({{0ms, a}, {100ms, b}, {200ms, a}});
  expectNear(path.velocityAt(0ms).linear, {10, 0, 0}, 1e-12);
  expectNear(path.velocityAt(400ms).linear, {-10, 0, 0}, 1e-12);
  expectNear(path.velocityAt(450ms).linear, {10, 0, 0}, 1e-12);
}

// The camera looks along x from 2 units beside the axis about which its body turns.
TEST(PathVelocity, OfAMountedCameraIsThatOfItsPlaceOnTheBody) {
  const Trajectory body({{0ms, {{}, {}}}, {1s, {{}, axisAngle({0, 1, 0})}}});
  const Pose mount{{2, 0, 0}, axisAngle({0, 1.57, 0})};
  const Trajectory path = body.mounted(mount);
  for (const TimeNs t : {10ms, 500ms, 990ms}) {
    const Velocity found = path.velocityAt(t), expected = differenceAt(path, t);
    expectNear(found.linear, expected.linear, 1e-3);
    expectNear(found.angular, expected.angular, 1e-3);
    EXPECT_EQ(path.bodyVelocityAt(t), body.velocityAt(t));
  }
}

TEST(PathVelocity, OfACameraThatStandsIsExactlyZero) {
  const Pose home{{0.1, 0.2, 0.3}, axisAngle({0.3, 0.8, -0.2})}, away{{0.1, 0.3, 0.3}, {}};
  const std::vector<TimedPose> keys{{0ms, home}, {100ms, home}, {200ms, away}};
  for (const Interpolation kind : {Interpolation::kLinear, Interpolation::kCubic}) {
    const Trajectory path(keys, kind);
    for (const TimeNs t : {0ms, 33ms, 100ms}) EXPECT_EQ(path.velocityAt(t), Velocity{});
    EXPECT_NE(path.velocityAt(150ms), Velocity{});
  }
}

}  // namespace
}  // namespace saccade
