#include "truth/imu/imu_noise.h"

#include <cmath>

#include "base/hash_rng.h"

namespace saccade {

// Discrete: [Kalibr, IMU noise model].
ImuNoise::ImuNoise(const ImuConfig& config) {
  const double root = std::sqrt(config.rate_hz);
  for (std::uint64_t i = 0; i < 6; ++i) {
    const std::uint64_t key = hashKey(config.seed, i);
    const bool force = i < 3;
    axes_.push_back({(force ? config.accelerometer_noise : config.gyroscope_noise) * root,
                     (force ? config.accelerometer_walk : config.gyroscope_walk) / root, key,
                     RandomWalk(hashKey(key, 0))});
  }
}

double ImuNoise::Axis::at(std::uint64_t sample) {
  double noise = 0;
  if (white > 0) noise += white * normalAt(hashKey(key, sample));
  if (walk > 0) noise += walk * bias.at(sample);
  return noise;
}

ImuReading ImuNoise::at(std::uint64_t sample) {
  const auto axis = [&](std::size_t i) { return axes_[i].at(sample); };
  return {{axis(0), axis(1), axis(2)}, {axis(3), axis(4), axis(5)}};
}

}  // namespace saccade
