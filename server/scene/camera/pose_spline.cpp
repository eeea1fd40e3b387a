#include "scene/camera/pose_spline.h"

namespace saccade {
namespace {

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

// The three steps of the control polygon, from one key to the next.
struct Steps {
  Vec3d moves[3], turns[3];
};

Steps stepsTo(std::span<const TimedPose> keys, std::size_t i) {
  const Pose &a = keys[i - 1].pose, &b = keys[i].pose;
  const Velocity v0 = velocityAt(keys, i - 1), v1 = velocityAt(keys, i);
  const double third = secondsTo(keys[i - 1], keys[i]) / 3;
  const Vec3d first = v0.linear * third, last = v1.linear * third;
  const Vec3d middle = b.position - a.position - first - last;
  if (a.rotation == b.rotation) return {{first, middle, last}, {}};
  const Vec3d turn0 = v0.angular * third, turn1 = v1.angular * third;
  const Quaternion step = conjugate(a.rotation) * b.rotation;
  return {{first, middle, last},
          {turn0, rotationVector(axisAngle(-turn0) * step * axisAngle(-turn1)), turn1}};
}

// Shares of the steps: sums of Bernstein polynomials.
struct Shares {
  double u1, u2, u3;
};

Shares sharesAt(double s) {
  return {1 - (1 - s) * (1 - s) * (1 - s), (3 - 2 * s) * s * s, s * s * s};
}
Shares slopesAt(double s) {
  return {3 * (1 - s) * (1 - s), 6 * s * (1 - s), 3 * s * s};
}

Vec3d rotateBack(Vec3d turn, Vec3d v) {
  return rotate(axisAngle(-turn), v);
}

}  // namespace

Pose interpolateCubic(std::span<const TimedPose> keys, std::size_t i, double s) {
  const Pose &a = keys[i - 1].pose, &b = keys[i].pose;
  if (s == 0) return a;
  const auto [moves, turns] = stepsTo(keys, i);
  const Shares u = sharesAt(s);
  Pose p{a.position + moves[0] * u.u1 + moves[1] * u.u2 + moves[2] * u.u3, a.rotation};
  if (a.rotation == b.rotation) return p;
  p.rotation = normalize(a.rotation * axisAngle(turns[0] * u.u1) * axisAngle(turns[1] * u.u2) *
                         axisAngle(turns[2] * u.u3));
  return p;
}

// Each factor of the rotation turns about an axis of its own; the factors after it turn that axis.
Velocity cubicVelocity(std::span<const TimedPose> keys, std::size_t i, double s) {
  const auto [moves, turns] = stepsTo(keys, i);
  const Shares u = sharesAt(s), slope = slopesAt(s);
  const Vec3d second = turns[1] * slope.u2 + rotateBack(turns[1] * u.u2, turns[0] * slope.u1);
  const Vec3d angular = turns[2] * slope.u3 + rotateBack(turns[2] * u.u3, second);
  const double span_s = secondsTo(keys[i - 1], keys[i]);
  const Vec3d linear = moves[0] * slope.u1 + moves[1] * slope.u2 + moves[2] * slope.u3;
  return {linear / span_s, angular / span_s};
}

}  // namespace saccade
