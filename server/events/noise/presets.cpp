#include "events/noise/presets.h"

#include "base/names.h"

namespace saccade {

// Contrast thresholds c of data sheets are percentages of intensity: C = log(1 + c). "Survey" is Table 1 of
// Gallego et al., Event-based Vision: A Survey, TPAMI 2022. Its stationary noise is split here into leak and
// shot noise.
const std::vector<SensorPreset>& sensorPresets() {
  static const std::vector<SensorPreset> table = {
      {"davis346",
       "DAVIS346, 346x260: C 14.3 % ON, 22.5 % OFF, 12 Meps, 0.1 Hz of noise (survey; Taverni et al., "
       "TCAS-II 2018); "
       "mismatch 0.15 C (v2e: 0.03 at C 0.2); assumed: bandwidth 300 Hz, refractory "
       "0.5 ms, hot 0.01 %, dead 0.01 %, jitter 10 us, buffer",
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
       "DVXplorer (Samsung DVS Gen3), 640x480: C 15 %, 0.03 Hz of noise (survey; Son et al., ISSCC 2017), "
       "165 Meps "
       "(maker's data sheet); assumed: mismatch 0.15 C, bandwidth 500 Hz, refractory 0.2 ms, hot 0.005 %, "
       "dead 0.005 %, "
       "jitter 50 us, buffer",
       0.1398,
       0.1398,
       0.0002,
       {.mismatch = 0.15,
        .photoreceptor_hz = 500,
        .leak_hz = 0.01,
        .shot_hz = 0.04,
        .hot_fraction = 5e-5,
        .dead_fraction = 5e-5,
        .jitter_s = 5e-5,
        .readout_hz = 165e6}},
      {"imx636",
       "Prophesee Gen4 and Sony IMX636, 1280x720: C 11 %, 1066 Meps, 0.1 Hz of noise (survey; Finateu et "
       "al., ISSCC "
       "2020); assumed: mismatch 0.15 C, bandwidth 1000 Hz, refractory 0.1 ms, hot 0.002 %, dead 0.002 %, "
       "jitter 20 us, "
       "buffer",
       0.1044,
       0.1044,
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
       "the sensor of low light that v2e calls noisy (Hu et al., CVPRW 2021, and its code): C 0.2, mismatch "
       "0.05 log "
       "units, bandwidth 30 Hz, leak 0.1 Hz, shot noise 5 Hz, refractory 10 ms",
       0.2,
       0.2,
       0.01,
       {.mismatch = 0.25, .photoreceptor_hz = 30, .leak_hz = 0.1, .shot_hz = 5}},
  };
  return table;
}

const SensorPreset* findPreset(const std::string& name) {
  return findRow(sensorPresets(), name);
}

std::string presetNames() {
  return joinRowNames(sensorPresets());
}

}  // namespace saccade
