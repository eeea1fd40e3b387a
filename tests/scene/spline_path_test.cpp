#include "scene/camera/spline_path.h"

#include <cmath>

#include "scene/camera/trajectory.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;

SplinePath path() {
  SplinePath p{8s, {}};
  for (int i = 0; i < 8; ++i) {
    const double a = i * 0.785;
    p.controls.push_back(
        {{std::cos(a), std::sin(2 * a), 0.1 * i * (8 - i)}, axisAngle({0.3 * std::sin(a), a, 0.2})});
  }
  return p;
}

TEST(SplinePath, GoesByItsControlsAndRepeats) {
  const SplinePath p = path();
  const Vec3d by = (p.controls[2].position + p.controls[3].position * 4.0 + p.controls[4].position) / 6.0;
  expectNear(p.at(3s).position, by, 1e-12);
  EXPECT_EQ(p.at(3s), p.at(11s));
  EXPECT_EQ(p.at(-5s), p.at(3s));
  std::vector<Vec3d> loop;
  for (const Pose& pose : p.controls) loop.push_back(pose.position);
  for (const double u : {0.0, 0.3, 4.5, 7.9})
    expectNear(loopAt(loop, u), p.at(TimeNs(std::llround(u * 1e9))).position, 1e-9);
}

TEST(SplinePath, ItsVelocityIsTheDerivative) {
  const SplinePath p = path();
  for (TimeNs t = 10ms; t < 8s; t += 130ms) {
    const Pose a = p.at(t - 10us), b = p.at(t + 10us);
    const Velocity v = p.velocityAt(t);
    expectNear(v.linear, (b.position - a.position) / 20e-6, 1e-6);
    expectNear(v.angular, rotationVector(conjugate(a.rotation) * b.rotation) / 20e-6, 1e-6);
  }
}

// At the controls and at the end of the period too.
TEST(SplinePath, ItsAccelerationIsContinuous) {
  const SplinePath p = path();
  for (TimeNs t = 0s; t < 9s; t += 500ms) {
    const auto acceleration = [&](TimeNs at) {
      const Velocity a = p.velocityAt(at - 1us), b = p.velocityAt(at + 1us);
      return Velocity{(b.linear - a.linear) / 2e-6, (b.angular - a.angular) / 2e-6};
    };
    const Velocity before = acceleration(t - 3us), after = acceleration(t + 3us);
    expectNear(before.linear, after.linear, 1e-3);
    expectNear(before.angular, after.angular, 1e-3);
  }
}

TEST(SplinePath, IsATrajectory) {
  const Trajectory t(path());
  EXPECT_EQ(t.lastTime(), 8s);
  EXPECT_EQ(t.at(3s), path().at(3s));
  EXPECT_EQ(t.velocityAt(3s), path().velocityAt(3s));
}

}  // namespace
}  // namespace saccade
