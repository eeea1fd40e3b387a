#include "scene/roam/level.h"

#include <cmath>

namespace saccade {
namespace {

Vec3d nearestAxis(Vec3d v) {
  const Vec3d a{std::abs(v.x), std::abs(v.y), std::abs(v.z)};
  if (a.x > a.y && a.x > a.z) return {std::copysign(1.0, v.x), 0, 0};
  if (a.y > a.z) return {0, std::copysign(1.0, v.y), 0};
  return {0, 0, std::copysign(1.0, v.z)};
}

}  // namespace

Vec3d Level::direction(double pan, double tilt) const {
  return (ahead * std::cos(pan) + right * std::sin(pan)) * std::cos(tilt) + up * std::sin(tilt);
}

Quaternion Level::rotation(Vec3d direction) const {
  const Vec3d z = normalize(direction), x = normalize(cross(z, up));
  return fromAxes(x, cross(z, x), z);
}

Level levelOf(const Quaternion& camera) {
  const Vec3d up = nearestAxis(rotate(camera, {0, -1, 0}));
  const Vec3d right = normalize(cross(rotate(camera, {0, 0, 1}), up));
  return {cross(up, right), right, up};
}

}  // namespace saccade
