#include "truth/imu/imu_motion.h"

namespace saccade {

ImuReading imuReading(const Trajectory& path, TimeNs t0, TimeNs t1, const ImuConfig& config) {
  const double dt = seconds(t1 - t0);
  const Quaternion q0 = path.bodyAt(t0).rotation, q1 = path.bodyAt(t1).rotation;
  const Vec3d turned = q0 == q1 ? Vec3d{} : rotationVector(conjugate(q0) * q1);
  const Quaternion middle = q0 * axisAngle(turned * 0.5);
  const Vec3d dv = (path.bodyVelocityAt(t1).linear - path.bodyVelocityAt(t0).linear) * config.metres_per_unit;
  return {rotate(conjugate(middle), dv * (1 / dt) - config.gravity), turned * (1 / dt)};
}

}  // namespace saccade
