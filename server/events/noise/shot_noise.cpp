#include "events/noise/shot_noise.h"

#include <algorithm>
#include <cmath>

#include "events/noise/noise_numbers.h"
#include "events/noise/rate_spread.h"

namespace saccade {

ShotNoise::ShotNoise(const SensorConfig& config, int width, int height)
    : key_(noiseKey(config.seed, NoiseNumbers::kShot)),
      width_(width),
      pixels_(static_cast<std::uint64_t>(width) * height),
      reference_(config.noise.reference_luminance),
      dark_(config.noise.dark_luminance) {
  double sum = static_cast<double>(pixels_);
  if (config.noise.rate_spread > 0) {
    sum = 0;
    for (std::uint32_t pixel = 0; pixel < pixels_; ++pixel)
      factors_.push_back(sum += rateFactor(config.noise.rate_spread, config.seed, pixel));
  }
  mean_gap_ns_ = 1e9 / (config.noise.shot_hz * sum);
}

double ShotNoise::shareOf(float I) const {
  constexpr double kBright = 0.25;  // SHOT_NOISE_INTEN_FACTOR of v2e
  const double bright = I - I == 0 ? std::clamp((I + dark_) / reference_, 0.0, 1.0) : 0;
  return 1 - (1 - kBright) * bright;
}

std::uint32_t ShotNoise::pixelOf(std::uint64_t number) const {
  if (factors_.empty()) return static_cast<std::uint32_t>(((number >> 32) * pixels_) >> 32);
  const double at = static_cast<double>(number >> 32) * 0x1p-32 * factors_.back();
  return static_cast<std::uint32_t>(std::ranges::upper_bound(factors_, at) - factors_.begin());
}

void ShotNoise::generate(const IntensityChange& change, NoiseSink& sink) {
  const std::uint64_t key = hashKey(key_, change.frame);
  const auto length = static_cast<double>((change.t1 - change.t0).count());
  double t = 0;  // since t0: what is left of a gap is as long as a new one
  for (std::uint64_t i = 0;; i += 3) {
    t -= mean_gap_ns_ * std::log(uniform(hashKey(key, i)));
    if (t >= length) return;
    const std::uint64_t where = hashKey(key, i + 1), what = hashKey(key, i + 2);
    const std::uint32_t pixel = pixelOf(where);
    const auto x = static_cast<int>(pixel % width_), y = static_cast<int>(pixel / width_);
    if (uniform(what) >= shareOf(change.I_now.at(x, y))) continue;
    const std::int64_t tick = static_cast<std::int64_t>(t) / kTimeUnitNs * kTimeUnitNs;
    sink.add(change.t0.count() + tick, pixel, width_, where & 1);
  }
}

}  // namespace saccade
