#include "scene/camera/sine_path.h"

#include <cmath>
#include <numbers>

namespace saccade {
namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;

double shareOf(TimeNs t, TimeNs period) {
  return seconds((t % period + period) % period) / seconds(period);
}

}  // namespace

double SineSum::at(double u) const {
  double sum = 0;
  for (const Sine& s : sines) sum += s.amplitude * std::sin(kFullTurn * s.cycles * u + s.phase);
  return sum + offset;
}

double SineSum::slopeAt(double u) const {
  double sum = 0;
  for (const Sine& s : sines)
    sum += s.amplitude * kFullTurn * s.cycles * std::cos(kFullTurn * s.cycles * u + s.phase);
  return sum;
}

Pose SinePath::at(TimeNs t) const {
  const double u = shareOf(t, period);
  const Quaternion turned =
      axisAngle({0, axes[3].at(u), 0}) * axisAngle({axes[4].at(u), 0, 0}) * axisAngle({0, 0, axes[5].at(u)});
  return home * Pose{{axes[0].at(u), axes[1].at(u), axes[2].at(u)}, turned};
}

// Each turn is about an axis of its own; the turns after it turn that axis.
Velocity SinePath::velocityAt(TimeNs t) const {
  const double u = shareOf(t, period), per_s = 1 / seconds(period);
  const auto rate = [&](std::size_t axis) { return axes[axis].slopeAt(u) * per_s; };
  const Vec3d upward = Vec3d{rate(4), 0, 0} + rotate(axisAngle({-axes[4].at(u), 0, 0}), {0, rate(3), 0});
  return {rotate(home.rotation, {rate(0), rate(1), rate(2)}),
          Vec3d{0, 0, rate(5)} + rotate(axisAngle({0, 0, -axes[5].at(u)}), upward)};
}

}  // namespace saccade
