#include "events/noise/noise_config.h"

namespace saccade {

std::span<const NoiseField> noiseFields() {
  static constexpr NoiseField kFields[] = {
      {"mismatch", &NoiseConfig::mismatch, ranges::kMismatch},
      {"photoreceptor_hz", &NoiseConfig::photoreceptor_hz, ranges::kBandwidth},
      {"follower_hz", &NoiseConfig::follower_hz, ranges::kBandwidth},
      {"asymmetry", &NoiseConfig::asymmetry, ranges::kAsymmetry},
      {"reference_luminance", &NoiseConfig::reference_luminance, ranges::kReference},
      {"dark_luminance", &NoiseConfig::dark_luminance, ranges::kDarkLuminance},
      {"level_leak_hz", &NoiseConfig::level_leak_hz, ranges::kLevelLeak},
      {"brownian_hz", &NoiseConfig::brownian_hz, ranges::kBrownian},
      {"leak_hz", &NoiseConfig::leak_hz, ranges::kNoiseRate},
      {"shot_hz", &NoiseConfig::shot_hz, ranges::kNoiseRate},
      {"rate_spread", &NoiseConfig::rate_spread, ranges::kRateSpread},
      {"hot_fraction", &NoiseConfig::hot_fraction, ranges::kPixelShare},
      {"hot_hz", &NoiseConfig::hot_hz, ranges::kHotRate},
      {"dead_fraction", &NoiseConfig::dead_fraction, ranges::kPixelShare},
      {"jitter_s", &NoiseConfig::jitter_s, ranges::kJitter},
      {"readout_hz", &NoiseConfig::readout_hz, ranges::kReadout},
      {"readout_buffer", &NoiseConfig::readout_buffer, ranges::kReadoutBuffer},
  };
  return kFields;
}

const char* changedPixelAmount(const NoiseConfig& before, const NoiseConfig& after) {
  static constexpr double NoiseConfig::*kOfPixels[] = {&NoiseConfig::mismatch, &NoiseConfig::rate_spread,
                                                       &NoiseConfig::brownian_hz};
  for (const NoiseField& field : noiseFields())
    for (const auto amount : kOfPixels)
      if (field.value == amount && before.*amount != after.*amount) return field.name;
  return nullptr;
}

double noiseRate(const NoiseConfig& noise) {
  return noise.leak_hz + noise.shot_hz + noise.hot_fraction * noise.hot_hz + noise.level_leak_hz +
         noise.brownian_hz * kMostBrownian;
}

}  // namespace saccade
