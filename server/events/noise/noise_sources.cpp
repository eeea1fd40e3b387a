#include "events/noise/noise_numbers.h"
#include "events/noise/noise_source.h"
#include "events/noise/periodic_noise.h"
#include "events/noise/pixel_choice.h"
#include "events/noise/shot_noise.h"
#include "events/noise/spread_leak.h"

namespace saccade {

std::vector<std::unique_ptr<NoiseSource>> makeNoiseSources(const SensorConfig& config, int width,
                                                           int height) {
  const NoiseConfig& noise = config.noise;
  const auto count = static_cast<std::uint32_t>(width * height);
  const auto key = [&](NoiseNumbers use) { return noiseKey(config.seed, use); };
  const auto periodic = [&](double fraction, double rate_hz, NoiseNumbers phase) {
    return std::make_unique<PeriodicNoise>(choosePixels(key(NoiseNumbers::kHotPixels), count, fraction),
                                           rate_hz, key(phase), width);
  };
  std::vector<std::unique_ptr<NoiseSource>> sources;
  if (noise.leak_hz > 0 && noise.rate_spread > 0) {
    sources.push_back(std::make_unique<SpreadLeak>(config, width, height));
  } else if (noise.leak_hz > 0) {
    sources.push_back(periodic(1, noise.leak_hz, NoiseNumbers::kLeakPhase));
  }
  if (noise.shot_hz > 0) {
    sources.push_back(std::make_unique<ShotNoise>(config, width, height));
  }
  if (noise.hot_fraction > 0 && noise.hot_hz > 0) {
    sources.push_back(periodic(noise.hot_fraction, noise.hot_hz, NoiseNumbers::kHotPhase));
  }
  return sources;
}

}  // namespace saccade
