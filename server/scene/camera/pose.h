// Rigid poses T_world_camera in double precision. Camera axes: x right, y down, z forward.
#pragma once

#include "base/vec.h"

namespace saccade {

// Unit quaternion, x y z w as in the trajectory files.
struct Quaternion {
  double x = 0, y = 0, z = 0, w = 1;
  friend bool operator==(const Quaternion&, const Quaternion&) = default;
};

struct Pose {
  Vec3d position;
  Quaternion rotation;
  friend bool operator==(const Pose&, const Pose&) = default;
};

// Per second: linear in world axes, scene units; angular in the camera's own axes, radians.
struct Velocity {
  Vec3d linear, angular;
  friend bool operator==(const Velocity&, const Velocity&) = default;
};

Quaternion operator*(Quaternion a, Quaternion b);
Quaternion normalize(Quaternion q);
Quaternion conjugate(Quaternion q);
// Whether q can be made unit length: 1e-6 < |q| < 1e6.
bool isRotation(Quaternion q);
// Unit length, and of q and -q, which are one rotation, the nearer to `prev`: equal rotations have equal
// bits.
Quaternion unitNear(Quaternion q, Quaternion prev);
Quaternion axisAngle(Vec3d axis_times_angle_rad);
Vec3d rotationVector(Quaternion q);  // the inverse of axisAngle(), the short way round
Vec3d rotate(Quaternion q, Vec3d v);
Pose operator*(const Pose& a, const Pose& b);
Pose inverse(const Pose& p);

// Rotation whose columns are the given right-handed orthonormal axes.
Quaternion fromAxes(Vec3d x, Vec3d y, Vec3d z);

// Interpolation along the screw motion of SE(3) from a (s = 0) to b (s = 1): a * exp(s * log(a^-1 b)).
// Returns the bits of `a` when a == b or s == 0, those of `b` when s == 1.
Pose interpolate(const Pose& a, const Pose& b, double s);
// Of a camera that goes along this motion in `span_s` seconds; exactly 0 when a == b.
Velocity interpolationVelocity(const Pose& a, const Pose& b, double s, double span_s);

}  // namespace saccade
