// Paths of sines against their closed form.
#include "scene/camera/sine_path.h"

#include <cmath>
#include <numbers>

#include "scene/camera/trajectory.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;

constexpr double kTurn = 2 * std::numbers::pi;

SinePath along(std::size_t axis, const SineSum& sum) {
  SinePath path{{}, 4s, {}};
  path.axes[axis] = sum;
  return path;
}

// 1 s is a quarter of the period.
TEST(SinePath, MovesAlongItsAxes) {
  const SineSum sum{{{2, 3, 0.7}, {0.5, 1, 0}}, 0.25};
  const double expected = 0.25 + 2 * std::sin(0.75 * kTurn + 0.7) + 0.5;
  expectNear(along(0, sum).at(1s).position, {expected, 0, 0}, 1e-12);
  expectNear(along(1, sum).at(1s).position, {0, expected, 0}, 1e-12);
  expectNear(along(2, sum).at(4s * 1'000'000 + 1s).position, {0, 0, expected}, 1e-12);
  expectNear(along(2, sum).at(-3s).position, {0, 0, expected}, 1e-12);
}

// Where the middle of the view, and what is to its right, has gone to.
TEST(SinePath, TurnsToTheRightAndUpAndClockwise) {
  const double a = 0.3;
  const auto turned = [&](std::size_t axis) { return along(axis, {{{a, 1, 0}}}).at(1s).rotation; };
  expectNear(rotate(turned(3), {0, 0, 1}), {std::sin(a), 0, std::cos(a)}, 1e-12);
  expectNear(rotate(turned(4), {0, 0, 1}), {0, -std::sin(a), std::cos(a)}, 1e-12);
  expectNear(rotate(turned(5), {1, 0, 0}), {std::cos(a), std::sin(a), 0}, 1e-12);
}

// The error of the central difference is quadratic in its step.
TEST(SinePath, ItsVelocityIsTheDerivative) {
  SinePath path{{{1, 2, 3}, axisAngle({0.3, -0.8, 0.2})}, 3s, {}};
  for (std::size_t i = 0; i < path.axes.size(); ++i) {
    const double phase = static_cast<double>(i);
    path.axes[i] = {{{0.4, 1, phase}, {0.3, 2, 2 * phase}, {0.2, 5, 3 * phase}}, 0.1};
  }
  const Trajectory trajectory(path);
  constexpr TimeNs kStep = 10us;
  for (TimeNs t{0}; t < 7s; t += 130ms) {
    const Pose before = path.at(t - kStep), after = path.at(t + kStep);
    const double span_s = seconds(2 * kStep);
    const Velocity v = trajectory.velocityAt(t);
    expectNear(v.linear, (after.position - before.position) / span_s, 1e-7);
    expectNear(v.angular, rotationVector(conjugate(before.rotation) * after.rotation) / span_s, 1e-7);
    EXPECT_EQ(trajectory.at(t), path.at(t));
  }
  EXPECT_EQ(trajectory.lastTime(), path.period);
}

}  // namespace
}  // namespace saccade
