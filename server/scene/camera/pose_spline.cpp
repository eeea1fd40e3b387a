#include "scene/camera/pose_spline.h"

namespace saccade {
namespace {

// Per second; `angular` in the camera's own axes.
struct Velocity {
  Vec3d linear, angular;
};

double secondsTo(const TimedPose& a, const TimedPose& b) {
  return seconds(b.time - a.time);
}

Velocity meanVelocity(const TimedPose& a, const TimedPose& b) {
  const double h = secondsTo(a, b);
  Velocity v{(b.pose.position - a.pose.position) / h, {}};
  if (a.pose.rotation != b.pose.rotation)
    v.angular = rotationVector(conjugate(a.pose.rotation) * b.pose.rotation) / h;
  return v;
}

// Slope at the middle one of three points, from the mean slopes over the intervals h0 before and h1 after it.
Vec3d parabolaSlope(Vec3d before, double h0, Vec3d after, double h1) {
  if (before == Vec3d{} || after == Vec3d{}) return {};
  return (before * h1 + after * h0) / (h0 + h1);
}

Velocity velocityAt(std::span<const TimedPose> keys, std::size_t i) {
  if (i == 0) return meanVelocity(keys[0], keys[1]);
  const Velocity before = meanVelocity(keys[i - 1], keys[i]);
  if (i + 1 == keys.size()) return before;
  const Velocity after = meanVelocity(keys[i], keys[i + 1]);
  const double h0 = secondsTo(keys[i - 1], keys[i]), h1 = secondsTo(keys[i], keys[i + 1]);
  return {parabolaSlope(before.linear, h0, after.linear, h1),
          parabolaSlope(before.angular, h0, after.angular, h1)};
}

}  // namespace

Pose interpolateCubic(std::span<const TimedPose> keys, std::size_t i, double s) {
  const Pose &a = keys[i - 1].pose, &b = keys[i].pose;
  if (s == 0) return a;
  const Velocity v0 = velocityAt(keys, i - 1), v1 = velocityAt(keys, i);
  const double third = secondsTo(keys[i - 1], keys[i]) / 3;
  // Sums of Bernstein polynomials: the shares of the three steps of the control polygon.
  const double u1 = 1 - (1 - s) * (1 - s) * (1 - s), u2 = (3 - 2 * s) * s * s, u3 = s * s * s;

  const Vec3d first = v0.linear * third, last = v1.linear * third;
  const Vec3d middle = b.position - a.position - first - last;
  Pose p{a.position + first * u1 + middle * u2 + last * u3, a.rotation};
  if (a.rotation == b.rotation) return p;

  const Vec3d turn0 = v0.angular * third, turn1 = v1.angular * third;
  const Quaternion step = conjugate(a.rotation) * b.rotation;
  const Vec3d turn = rotationVector(axisAngle(-turn0) * step * axisAngle(-turn1));
  p.rotation = normalize(a.rotation * axisAngle(turn0 * u1) * axisAngle(turn * u2) * axisAngle(turn1 * u3));
  return p;
}

}  // namespace saccade
