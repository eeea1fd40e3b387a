#include "scene/camera/pose.h"

#include <cmath>
#include <numbers>

#include "scene/scratch.h"

namespace saccade {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Pose, RotateTurnsCounterClockwise) {
  expectNear(rotate(axisAngle({0, 0, kPi / 2}), {1, 0, 0}), {0, 1, 0}, 1e-15);
}

TEST(Pose, RotationVectorIsTheInverseOfAxisAngle) {
  for (const Vec3d w : {Vec3d{0, 0, 0}, {1e-9, 0, 0}, {0.3, -0.2, 0.9}, {0, 3.1, 0}})
    expectNear(rotationVector(axisAngle(w)), w, 1e-12);
  expectNear(rotationVector(axisAngle({0, 0, 2 * kPi - 0.1})), {0, 0, -0.1}, 1e-12);  // the short way round
}

TEST(Pose, EqualRotationsBecomeEqualBits) {
  const Quaternion q{0.1, -0.2, 0.3, -0.9}, opposite{-0.1, 0.2, -0.3, 0.9};
  const Quaternion unit = unitNear(q, q);
  EXPECT_NEAR(unit.x * unit.x + unit.y * unit.y + unit.z * unit.z + unit.w * unit.w, 1, 1e-15);
  EXPECT_GT(unit.x, 0);
  EXPECT_EQ(unitNear(opposite, unit), unit);
}

TEST(Pose, FromAxesIsTheRotationWithTheseColumns) {
  for (const Vec3d w : {Vec3d{0.3, 0.2, 0.1}, {3.1, 0, 0.1}, {0, 3.1, 0.2}, {0.1, 0, -3.1}, {0, 0, kPi}}) {
    const Quaternion q = axisAngle(w);
    const Quaternion r = fromAxes(rotate(q, {1, 0, 0}), rotate(q, {0, 1, 0}), rotate(q, {0, 0, 1}));
    expectNear(rotate(r, {1, 2, 3}), rotate(q, {1, 2, 3}), 1e-12);
  }
}

TEST(Pose, InverseUndoes) {
  const Pose p{{1, 2, 3}, axisAngle({0.5, -0.4, 0.9})};
  const Pose identity = p * inverse(p);
  expectNear(identity.position, {0, 0, 0}, 1e-14);
  EXPECT_NEAR(identity.rotation.w, 1, 1e-14);
}

// A screw about the z axis through (1, 2, 0): the angle and the rise grow in proportion to s.
TEST(Interpolate, FollowsTheScrew) {
  const double angle = 2.0, rise = 3.0;
  const auto screw = [&](double s) {
    const Quaternion q = axisAngle({0, 0, s * angle});
    const Vec3d center{1, 2, 0};
    return Pose{center - rotate(q, center) + Vec3d{0, 0, s * rise}, q};
  };
  const Pose start{{4, -1, 2}, axisAngle({0.3, 0.1, -0.2})};
  for (const double s : {0.1, 0.25, 0.5, 0.9}) {
    const Pose p = interpolate(start, screw(1) * start, s), expected = screw(s) * start;
    expectNear(p.position, expected.position, 1e-12);
    expectNear(rotate(p.rotation, {1, 2, 3}), rotate(expected.rotation, {1, 2, 3}), 1e-12);
  }
}

TEST(Interpolate, SmallTurnsAgreeWithTheirLimit) {
  for (const double angle : {0.0, 1e-9, 0.99e-4, 1.01e-4}) {
    const Pose b{{1, 0, 0}, axisAngle({0, 0, angle})};
    // To first order in the angle, the arc from the origin to (1, 0, 0) bulges by angle / 8 half-way.
    expectNear(interpolate({}, b, 0.5).position, {0.5, -angle / 8, 0}, 1e-9);
  }
}

TEST(Interpolate, TakesTheShortWayRound) {
  Quaternion q = axisAngle({0, 0, 0.2});
  q = {-q.x, -q.y, -q.z, -q.w};
  expectNear(rotate(interpolate({}, {{}, q}, 0.5).rotation, {1, 0, 0}), {std::cos(0.1), std::sin(0.1), 0},
             1e-12);
}

TEST(Interpolate, KeepsTheBitsOfEqualPosesAndOfTheEnds) {
  const Pose a{{0.1, 0.2, 0.3}, normalize(Quaternion{0.1, 0.7, 0.3, 0.6})};
  const Pose b{{0.4, 0.2, 0.7}, normalize(Quaternion{0.2, 0.7, 0.3, 0.6})};
  EXPECT_EQ(interpolate(a, a, 0.37), a);
  EXPECT_EQ(interpolate(a, b, 0), a);
  EXPECT_EQ(interpolate(a, b, 1), b);
}

}  // namespace
}  // namespace saccade
