#include "events/noise/level_leak.h"

#include "events/noise/rate_spread.h"

namespace saccade {

LevelLeak::LevelLeak(const SensorConfig& config, int width, int height)
    : slope_(static_cast<float>(config.noise.level_leak_hz * config.threshold)) {
  if (config.noise.rate_spread == 0) return;
  slopes_.emplace(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto pixel = static_cast<std::uint32_t>(y * width + x);
      slopes_->at(x, y) =
          slope_ * static_cast<float>(rateFactor(config.noise.rate_spread, config.seed, pixel));
    }
}

void LevelLeak::add(TimeNs length, ImageF& dL, const ImageF* from) const {
  const auto time = static_cast<float>(seconds(length));
  for (int y = 0; y < dL.height(); ++y) {
    float* row = dL.row(y);
    for (int x = 0; x < dL.width(); ++x) row[x] += slope(x, y) * (from ? 1 - from->at(x, y) : 1) * time;
  }
}

void LevelLeak::add(TimeNs length, Pieces& pieces) const {
  const auto time = static_cast<float>(seconds(length));
  for (int i = 0; i < pieces.count; ++i)
    pieces.dL[i] += slope(pieces.x[i], pieces.y[i]) * (pieces.to[i] - pieces.from[i]) * time;
}

}  // namespace saccade
