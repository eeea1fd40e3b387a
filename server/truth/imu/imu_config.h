// An inertial measurement unit that is fixed to the body, in its origin and axes.
#pragma once

#include <cstdint>

#include "base/vec.h"

namespace saccade {

// Densities of noise are those of continuous time, as in Kalibr's imu.yaml. Ranges are those of v1::Imu.
struct ImuConfig {
  double rate_hz = 200;
  double metres_per_unit = 1;      // of the scene
  Vec3d gravity = {0, -9.81, 0};   // m/s^2, world axes
  double accelerometer_noise = 0;  // white, m/s^2/sqrt(Hz)
  double gyroscope_noise = 0;      // white, rad/s/sqrt(Hz)
  double accelerometer_walk = 0;   // of the bias, m/s^3/sqrt(Hz)
  double gyroscope_walk = 0;       // of the bias, rad/s^2/sqrt(Hz)
  std::uint64_t seed = 0;
};

struct ImuReading {
  Vec3d force;  // specific force, m/s^2
  Vec3d rate;   // angular velocity, rad/s
};

}  // namespace saccade
