#include "truth/imu/imu_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace saccade {
namespace {

using namespace std::chrono_literals;

constexpr double kG = 9.81;

void expectNear(Vec3d found, Vec3d expected, double tolerance) {
  EXPECT_LT(length(found - expected), tolerance) << found.x << " " << found.y << " " << found.z << ", not "
                                                 << expected.x << " " << expected.y << " " << expected.z;
}

TEST(ImuMotion, ABodyThatStandsMeasuresGravityUpwards) {
  const Quaternion q = normalize({0.3, -0.2, 0.5, 0.7});
  const Trajectory path({{0s, {{1, 2, 3}, q}}});
  const ImuReading found = imuReading(path, 5ms, 10ms, {});
  expectNear(found.force, rotate(conjugate(q), {0, kG, 0}), 1e-12);
  EXPECT_EQ(found.rate, Vec3d{});
}

TEST(ImuMotion, AConstantTurnHasItsRateInTheAxesOfTheBody) {
  const Quaternion tilt = axisAngle({0.4, 0, 0});
  const Trajectory path({{0s, {{}, tilt}}, {2s, {{}, tilt * axisAngle({0, 0, 1.5})}}});
  expectNear(imuReading(path, 100ms, 105ms, {}).rate, {0, 0, 0.75}, 1e-9);
}

// On a circle of radius r at w radians per second the acceleration is w^2 r inwards. The mean over dt is
// smaller by 1 - sin(w dt / 2) / (w dt / 2), which is 2.3e-6 here.
TEST(ImuMotion, ACircleHasItsCentripetalAcceleration) {
  constexpr double kRadius = 3, kRate = 1.5;
  const Pose start{{kRadius, 0, 0}, {}};
  const Pose quarter{{0, 0, -kRadius}, axisAngle({0, std::numbers::pi / 2, 0})};
  const auto span = TimeNs{std::llround(std::numbers::pi / 2 / kRate * 1e9)};
  const Trajectory path({{0s, start}, {span, quarter}});  // a screw motion about the y axis
  const ImuConfig config{.metres_per_unit = 0.5};
  const ImuReading found = imuReading(path, 400ms, 405ms, config);
  expectNear(found.force, {-kRate * kRate * kRadius * 0.5, kG, 0}, 2e-5);
  expectNear(found.rate, {0, kRate, 0}, 1e-8);
}

TEST(ImuMotion, FallingFreelyIsWeightless) {
  std::vector<TimedPose> keys;
  for (int i = 0; i <= 100; ++i) {
    const double t = 0.01 * i;
    keys.push_back({i * 10ms, {{t, -kG / 2 * t * t, 0}, {}}});
  }
  const Trajectory path(std::move(keys), Interpolation::kCubic);
  expectNear(imuReading(path, 400ms, 405ms, {}).force, {}, 1e-4);
}

// Readings integrate to the path, also across keys where the velocity jumps.
TEST(ImuMotion, ReadingsGiveThePathBack) {
  const Pose a{{1, 0, 2}, normalize({0.1, 0.2, -0.1, 1})}, b{{2, 1, 1}, normalize({-0.2, 0.4, 0.3, 1})},
      c{{0, 2, 3}, normalize({0.5, -0.1, 0.2, 1})};
  const Trajectory path({{0ms, a}, {301ms, b}, {702ms, c}});
  const ImuConfig config{.metres_per_unit = 2, .gravity = {1, -2, 9}};
  Quaternion q = a.rotation;
  Vec3d v = path.bodyVelocityAt(0ms).linear * config.metres_per_unit;
  constexpr double kDt = 0.005;
  for (TimeNs t = 0ms; t < 600ms; t += 5ms) {
    const ImuReading r = imuReading(path, t, t + 5ms, config);
    v = v + (config.gravity + rotate(q * axisAngle(r.rate * (kDt / 2)), r.force)) * kDt;
    q = normalize(q * axisAngle(r.rate * kDt));
  }
  expectNear(v, path.bodyVelocityAt(600ms).linear * config.metres_per_unit, 1e-9);
  expectNear(rotationVector(conjugate(q) * path.at(600ms).rotation), {}, 1e-9);
}

}  // namespace
}  // namespace saccade
