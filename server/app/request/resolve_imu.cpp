#include "app/request/read_pose.h"
#include "app/request/refusal.h"
#include "app/request/resolve_truth.h"

namespace saccade {
namespace {

constexpr double kMaxGravity = 1e3;  // along each axis, m/s^2

void fillDefaults(v1::Imu& imu, std::uint64_t seed) {
  const ImuConfig defaults;
  if (imu.rate_hz() == 0) imu.set_rate_hz(defaults.rate_hz);
  if (!imu.has_metres_per_unit()) imu.set_metres_per_unit(defaults.metres_per_unit);
  if (!imu.has_gravity()) imu.mutable_gravity()->set_y(defaults.gravity.y);
  if (!imu.has_seed()) imu.set_seed(seed);
}

}  // namespace

ImuConfig resolveImu(v1::Imu& imu, const std::string& field, std::uint64_t seed) {
  fillDefaults(imu, seed);
  checkRange(field + ".rate_hz", imu.rate_hz(), ranges::kImuRate);
  checkRange(field + ".metres_per_unit", imu.metres_per_unit(), ranges::kMetresPerUnit);
  checkRange(field + ".accelerometer_noise", imu.accelerometer_noise(), ranges::kImuNoise);
  checkRange(field + ".gyroscope_noise", imu.gyroscope_noise(), ranges::kImuNoise);
  checkRange(field + ".accelerometer_walk", imu.accelerometer_walk(), ranges::kImuWalk);
  checkRange(field + ".gyroscope_walk", imu.gyroscope_walk(), ranges::kImuWalk);
  return {.rate_hz = imu.rate_hz(),
          .metres_per_unit = imu.metres_per_unit(),
          .gravity = readVector(imu.gravity(), {-kMaxGravity, kMaxGravity}, field + ".gravity"),
          .accelerometer_noise = imu.accelerometer_noise(),
          .gyroscope_noise = imu.gyroscope_noise(),
          .accelerometer_walk = imu.accelerometer_walk(),
          .gyroscope_walk = imu.gyroscope_walk(),
          .seed = imu.seed()};
}

}  // namespace saccade
