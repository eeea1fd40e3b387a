// The sensors of known cameras.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "events/noise/noise_config.h"

namespace saccade {

struct SensorPreset {
  std::string name, description;    // with the sources of the values
  double threshold, threshold_off;  // natural log units
  double refractory_s;
  NoiseConfig noise;
};

// THE list of presets.
const std::vector<SensorPreset>& sensorPresets();
const SensorPreset* findPreset(const std::string& name);  // nullptr if there is none
std::string presetNames();                                // "davis346, ..." for messages

struct Thresholds {
  double on, off;  // natural log units
};
// Those of a sensor like the preset's. Where one is given, the other keeps the proportion that it has in the
// preset.
Thresholds thresholdsOf(const SensorPreset& preset, std::optional<double> on, std::optional<double> off);

}  // namespace saccade
