// The noise of an IMU: white noise, and a bias that walks. Any sample can be asked for on its own.
#pragma once

#include "truth/imu/imu_config.h"

namespace saccade {

// A random walk after so many independent steps of variance 1, from 0: equal for equal keys. It costs at most
// 40 normal numbers, whatever the step: Levy's construction of Brownian motion halves intervals.
// 0 <= step < 2^40.
double randomWalk(std::uint64_t key, std::uint64_t step);

// What is added to sample 1, 2, ...
ImuReading imuNoise(const ImuConfig& config, std::uint64_t sample);

}  // namespace saccade
