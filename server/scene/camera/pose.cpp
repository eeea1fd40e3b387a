#include "scene/camera/pose.h"

#include <cmath>

#include "scene/camera/screw_step.h"

namespace saccade {
namespace {

Vec3d vectorPart(Quaternion q) {
  return {q.x, q.y, q.z};
}

double innerProduct(Quaternion a, Quaternion b) {
  return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}

// The inverse of screwStep(): the velocity that ends at p after one unit of turning by w.
Vec3d velocityTo(Vec3d w, Vec3d p) {
  const double angle = length(w), half = angle / 2;
  const double c = angle < kSmallAngle ? 1.0 / 12 + angle * angle / 720
                                       : (1 - half * std::cos(half) / std::sin(half)) / (angle * angle);
  const Vec3d wp = cross(w, p);
  return p - wp * 0.5 + cross(w, wp) * c;
}

}  // namespace

Quaternion operator*(Quaternion a, Quaternion b) {
  const Vec3d u = vectorPart(a), v = vectorPart(b);
  const Vec3d r = u * b.w + v * a.w + cross(u, v);
  return {r.x, r.y, r.z, a.w * b.w - dot(u, v)};
}

Quaternion normalize(Quaternion q) {
  const double s = 1 / std::sqrt(innerProduct(q, q));
  return {q.x * s, q.y * s, q.z * s, q.w * s};
}

Quaternion conjugate(Quaternion q) {
  return {-q.x, -q.y, -q.z, q.w};
}

bool isRotation(Quaternion q) {
  const double norm2 = innerProduct(q, q);
  return norm2 > 1e-12 && norm2 < 1e12;
}

Quaternion unitNear(Quaternion q, Quaternion prev) {
  const Quaternion unit = normalize(q);
  return innerProduct(unit, prev) < 0 ? Quaternion{-unit.x, -unit.y, -unit.z, -unit.w} : unit;
}

Quaternion axisAngle(Vec3d axis_times_angle_rad) {
  const double angle = length(axis_times_angle_rad);
  const double s = angle < kSmallAngle ? 0.5 - angle * angle / 48 : std::sin(angle / 2) / angle;
  const Vec3d v = axis_times_angle_rad * s;
  return {v.x, v.y, v.z, std::cos(angle / 2)};
}

Vec3d rotationVector(Quaternion q) {
  if (q.w < 0) q = {-q.x, -q.y, -q.z, -q.w};
  const Vec3d v = vectorPart(q);
  const double sine = length(v);
  const double angle = 2 * std::atan2(sine, q.w);
  return v * (angle < kSmallAngle ? 2.0 / q.w : angle / sine);
}

Vec3d rotate(Quaternion q, Vec3d v) {
  const Vec3d u = vectorPart(q), t = cross(u, v) * 2.0;
  return v + t * q.w + cross(u, t);
}

Pose operator*(const Pose& a, const Pose& b) {
  return {a.position + rotate(a.rotation, b.position), a.rotation * b.rotation};
}

Pose inverse(const Pose& p) {
  const Quaternion q = conjugate(p.rotation);
  return {-rotate(q, p.position), q};
}

Quaternion fromAxes(Vec3d x, Vec3d y, Vec3d z) {
  // Of the four forms, take the one whose divisor is largest.
  const double trace = x.x + y.y + z.z;
  if (trace > 0) return normalize({y.z - z.y, z.x - x.z, x.y - y.x, 1 + trace});
  if (x.x >= y.y && x.x >= z.z) return normalize({1 + x.x - y.y - z.z, x.y + y.x, z.x + x.z, y.z - z.y});
  if (y.y >= z.z) return normalize({x.y + y.x, 1 + y.y - x.x - z.z, y.z + z.y, z.x - x.z});
  return normalize({z.x + x.z, y.z + z.y, 1 + z.z - x.x - y.y, x.y - y.x});
}

Pose interpolate(const Pose& a, const Pose& b, double s) {
  if (s == 0 || a == b) return a;
  if (s == 1) return b;
  const Pose step = inverse(a) * b;
  const Vec3d w = rotationVector(step.rotation), v = velocityTo(w, step.position);
  Pose p = a * screwStep(w * s, v * s);
  p.rotation = normalize(p.rotation);
  return p;
}

// The screw is constant in the axes of the camera.
Velocity interpolationVelocity(const Pose& a, const Pose& b, double s, double span_s) {
  if (a == b) return {};
  const Pose step = inverse(a) * b;
  const Vec3d w = rotationVector(step.rotation), v = velocityTo(w, step.position);
  return {rotate(a.rotation * axisAngle(w * s), v) / span_s, w / span_s};
}

}  // namespace saccade
