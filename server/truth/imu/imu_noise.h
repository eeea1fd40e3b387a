// The noise of an IMU: white noise, and a bias that walks. Any sample can be asked for on its own.
#pragma once

#include <vector>

#include "truth/imu/imu_config.h"
#include "truth/imu/random_walk.h"

namespace saccade {

class ImuNoise {
 public:
  explicit ImuNoise(const ImuConfig& config);

  // The noise of sample 1, 2, ...: equal for equal configs, in whatever order it is asked for.
  ImuReading at(std::uint64_t sample);

 private:
  struct Axis {
    double white, walk;  // standard deviations of a sample, and of a step of the bias
    std::uint64_t key;
    RandomWalk bias;
    double at(std::uint64_t sample);
  };
  std::vector<Axis> axes_;  // x, y, z of the accelerometer, and then of the gyroscope
};

}  // namespace saccade
