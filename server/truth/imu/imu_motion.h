// The measurement of an IMU without noise on a path.
#pragma once

#include "scene/camera/trajectory.h"
#include "truth/imu/imu_config.h"

namespace saccade {

// The means over [t0, t1), 0 <= t0 < t1, as a device has that integrates: the path may jump in its velocity.
// Readings give the path back exactly. With dt = t1 - t0, v in metres per second and R = R_world_body:
//   R(t1) = R(t0) exp(rate dt)
//   v(t1) = v(t0) + (gravity + R(t0) exp(rate dt / 2) force) dt
ImuReading imuReading(const Trajectory& path, TimeNs t0, TimeNs t1, const ImuConfig& config);

}  // namespace saccade
