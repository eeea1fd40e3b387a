#include "events/noise/noise_config.h"

namespace saccade {

std::span<const NoiseField> noiseFields() {
  static constexpr NoiseField kFields[] = {
      {"mismatch", &NoiseConfig::mismatch, ranges::kMismatch},
      {"photoreceptor_hz", &NoiseConfig::photoreceptor_hz, ranges::kBandwidth},
      {"follower_hz", &NoiseConfig::follower_hz, ranges::kBandwidth},
      {"reference_luminance", &NoiseConfig::reference_luminance, ranges::kReference},
      {"leak_hz", &NoiseConfig::leak_hz, ranges::kNoiseRate},
      {"shot_hz", &NoiseConfig::shot_hz, ranges::kNoiseRate},
      {"hot_fraction", &NoiseConfig::hot_fraction, ranges::kPixelShare},
      {"hot_hz", &NoiseConfig::hot_hz, ranges::kHotRate},
      {"dead_fraction", &NoiseConfig::dead_fraction, ranges::kPixelShare},
      {"jitter_s", &NoiseConfig::jitter_s, ranges::kJitter},
      {"readout_hz", &NoiseConfig::readout_hz, ranges::kReadout},
      {"readout_buffer", &NoiseConfig::readout_buffer, ranges::kReadoutBuffer},
  };
  return kFields;
}

double noiseRate(const NoiseConfig& noise) {
  return noise.leak_hz + noise.shot_hz + noise.hot_fraction * noise.hot_hz;
}

}  // namespace saccade
