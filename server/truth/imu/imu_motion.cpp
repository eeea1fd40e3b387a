#include "truth/imu/imu_motion.h"

namespace saccade {
namespace {

constexpr TimeNs kStep{20'000};  // short against the fastest IMU, long against rounding

}  // namespace

// The slope at the end of the parabola through three positions [ours].
Vec3d velocityBefore(const Trajectory& path, TimeNs t) {
  const TimeNs step = t > TimeNs{0} ? -kStep : kStep;
  const Vec3d p0 = path.bodyAt(t).position, p1 = path.bodyAt(t + step).position,
              p2 = path.bodyAt(t + 2 * step).position;
  return ((p1 - p0) * 4.0 - (p2 - p0)) * (1 / (2 * seconds(step)));
}

ImuReading imuReading(const Trajectory& path, TimeNs t0, TimeNs t1, const ImuConfig& config) {
  const double dt = seconds(t1 - t0);
  const Quaternion q0 = path.bodyAt(t0).rotation, q1 = path.bodyAt(t1).rotation;
  const Vec3d turned = q0 == q1 ? Vec3d{} : rotationVector(conjugate(q0) * q1);
  const Quaternion middle = q0 * axisAngle(turned * 0.5);
  const Vec3d dv = (velocityBefore(path, t1) - velocityBefore(path, t0)) * config.metres_per_unit;
  return {rotate(conjugate(middle), dv * (1 / dt) - config.gravity), turned * (1 / dt)};
}

}  // namespace saccade
