#include "events/noise/presets.h"

#include "base/names.h"

namespace saccade {

// A contrast c of a data sheet is a percentage of intensity: C = log(1 + c). The table in events/README.md
// gives the source of each value.
const std::vector<SensorPreset>& sensorPresets() {
  static const std::vector<SensorPreset> table = {
      {"davis346",
       "DAVIS346, 346x260: C 14.3 % ON, 22.5 % OFF, 12 Meps (maker's page); mismatch 0.15 C, refractory "
       "0.5 ms, bandwidth 300 Hz (defaults of v2e); assumed: leak, shot noise, hot, dead, jitter, buffer",
       0.1337,
       0.2029,
       0.0005,
       {.mismatch = 0.15,
        .photoreceptor_hz = 300,
        .leak_hz = 0.07,
        .shot_hz = 0.08,
        .hot_fraction = 1e-4,
        .dead_fraction = 1e-4,
        .jitter_s = 1e-5,
        .readout_hz = 12e6}},
      {"dvxplorer",
       "DVXplorer, 640x480: C 13 % for half and 27.5 % for 99.9 % of the pixels, 165 Meps, times of 200 us "
       "(maker's page); assumed: bandwidth 500 Hz, leak, shot noise, hot, dead, buffer",
       0.1222,
       0.1222,
       0.0002,
       {.mismatch = 0.32,
        .photoreceptor_hz = 500,
        .leak_hz = 0.01,
        .shot_hz = 0.04,
        .hot_fraction = 5e-5,
        .dead_fraction = 5e-5,
        .jitter_s = 5.8e-5,
        .readout_hz = 165e6}},
      {"imx636",
       "Sony IMX636, 1280x720: C 25 % (Prophesee's EVK4), 1066 Meps (Finateu et al., ISSCC 2020); assumed: "
       "mismatch 0.15 C, bandwidth 1000 Hz, refractory 0.1 ms, leak, shot noise, hot, dead, jitter, buffer",
       0.2231,
       0.2231,
       0.0001,
       {.mismatch = 0.15,
        .photoreceptor_hz = 1000,
        .leak_hz = 0.04,
        .shot_hz = 0.12,
        .hot_fraction = 2e-5,
        .dead_fraction = 2e-5,
        .jitter_s = 2e-5,
        .readout_hz = 1066e6}},
      {"v2e-noisy",
       "the sensor of low light that v2e calls noisy (its code of 2025): C 0.2, mismatch 0.05 log units, "
       "bandwidth 30 Hz, leak 0.1 Hz, shot noise 5 Hz, no refractory period",
       0.2,
       0.2,
       0,
       {.mismatch = 0.25, .photoreceptor_hz = 30, .leak_hz = 0.1, .shot_hz = 5}},
  };
  return table;
}

const SensorPreset* findPreset(const std::string& name) {
  return findRow(sensorPresets(), name);
}

Thresholds thresholdsOf(const SensorPreset& preset, std::optional<double> on, std::optional<double> off) {
  if (!on && !off) return {preset.threshold, preset.threshold_off};
  if (!on) on = *off * (preset.threshold / preset.threshold_off);
  if (!off) off = *on * (preset.threshold_off / preset.threshold);
  return {*on, *off};
}

std::string presetNames() {
  return joinRowNames(sensorPresets());
}

}  // namespace saccade
