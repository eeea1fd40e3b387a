#include "truth/imu/imu_noise.h"

#include <cmath>
#include <numbers>

#include "base/check.h"
#include "base/hash_rng.h"

namespace saccade {
namespace {

// In (0, 1).
double unitAt(std::uint64_t key) {
  return (static_cast<double>(key >> 11) + 0.5) * 0x1p-53;
}

// Standard normal [Box, Muller 1958].
double normalAt(std::uint64_t key) {
  const double radius = std::sqrt(-2 * std::log(unitAt(hashKey(key, 0))));
  return radius * std::cos(2 * std::numbers::pi * unitAt(hashKey(key, 1)));
}

// The noise of three axes whose keys begin at `first`. Discrete: [Kalibr, IMU noise model].
Vec3d noiseOf(double white, double walk, const ImuConfig& config, std::uint64_t first, std::uint64_t sample) {
  const auto axis = [&](std::uint64_t i) {
    const std::uint64_t white_key = hashKey(config.seed, first + i), walk_key = hashKey(white_key, 0);
    double noise = 0;
    if (white > 0) noise += white * std::sqrt(config.rate_hz) * normalAt(hashKey(white_key, sample));
    if (walk > 0) noise += walk / std::sqrt(config.rate_hz) * randomWalk(walk_key, sample);
    return noise;
  };
  return {axis(0), axis(1), axis(2)};
}

}  // namespace

// Between two known values an interval apart, the middle is normal about their mean, with variance
// interval / 4.
double randomWalk(std::uint64_t key, std::uint64_t step) {
  constexpr std::uint64_t kSteps = std::uint64_t{1} << 40;
  SACCADE_CHECK(step < kSteps);
  std::uint64_t begin = 0, node = 1;
  double left = 0, right = std::sqrt(static_cast<double>(kSteps)) * normalAt(hashKey(key, 0));
  for (std::uint64_t span = kSteps; begin != step; span /= 2) {
    const double spread = std::sqrt(static_cast<double>(span)) / 2;
    const double middle = (left + right) / 2 + spread * normalAt(hashKey(key, node));
    const bool later = step >= begin + span / 2;
    if (later) begin += span / 2;
    (later ? left : right) = middle;
    node = 2 * node + (later ? 1 : 0);
  }
  return left;
}

ImuReading imuNoise(const ImuConfig& config, std::uint64_t sample) {
  return {noiseOf(config.accelerometer_noise, config.accelerometer_walk, config, 0, sample),
          noiseOf(config.gyroscope_noise, config.gyroscope_walk, config, 3, sample)};
}

}  // namespace saccade
