// How a body lies at one time, against the place that the scene file gives it.
#pragma once

#include "scene/scene.h"

namespace saccade {

// Scene axes. The columns x, y and z of the rotation are unit vectors.
struct RigidMotion {
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, translation{};

  // From the file's place to that of the time.
  Vec3 direction(Vec3 d) const { return x * d.x + y * d.y + z * d.z; }
  Vec3 point(Vec3 p) const { return direction(p) + translation; }
  // And back.
  Vec3 restDirection(Vec3 d) const { return {dot(x, d), dot(y, d), dot(z, d)}; }
  Vec3 restPoint(Vec3 p) const { return restDirection(p - translation); }

  friend bool operator==(const RigidMotion&, const RigidMotion&) = default;
};

// `pose`: in the scene's axes. It is exactly none at {centre, no rotation}.
inline RigidMotion motionOf(const Body& body, const Pose& pose) {
  const auto column = [&](Vec3d axis) { return toFloat(rotate(pose.rotation, axis)); };
  const Vec3d centre = toDouble(body.centre());
  return {column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1}),
          toFloat(pose.position - rotate(pose.rotation, centre))};
}

}  // namespace saccade
