#include "events/pixel_thresholds.h"

#include <algorithm>

#include "events/noise/noise_numbers.h"

namespace saccade {
namespace {

// A pixel keeps at least this share of C, so that its threshold is positive.
constexpr double kLeastShare = 0.1;

void fillGaussian(double C, double mismatch, std::uint64_t key, ImageF& image) {
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const std::uint64_t pixel = static_cast<std::uint64_t>(y) * image.width() + x;
      const double share = 1 + mismatch * gaussian(hashKey(key, pixel));
      image.at(x, y) = static_cast<float>(C * std::max(kLeastShare, share));
    }
  }
}

}  // namespace

OwnThresholds::OwnThresholds(const SensorConfig& config, int width, int height)
    : on_(width, height), off_(width, height) {
  const double mismatch = config.noise.mismatch;
  fillGaussian(config.threshold, mismatch, noiseKey(config.seed, NoiseNumbers::kThresholdOn), on_);
  fillGaussian(config.threshold_off, mismatch, noiseKey(config.seed, NoiseNumbers::kThresholdOff), off_);
}

}  // namespace saccade
