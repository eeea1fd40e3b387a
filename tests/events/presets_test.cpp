// Presets against the figures of the data sheets.
#include "events/noise/presets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "events/sensor_config.h"

namespace saccade {
namespace {

SensorConfig configOf(const SensorPreset& preset) {
  return {.threshold = preset.threshold,
          .threshold_off = preset.threshold_off,
          .refractory = TimeNs(std::llround(preset.refractory_s * 1e9)),
          .noise = preset.noise};
}

TEST(Presets, AreValidSensors) {
  for (const SensorPreset& preset : sensorPresets()) {
    const auto fault = findFault(configOf(preset));
    EXPECT_FALSE(fault) << preset.name << ": " << fault->field << ": " << fault->message;
  }
}

// A contrast is a relative change of intensity.
TEST(Presets, HaveTheContrastsOfDataSheets) {
  const struct {
    const char* preset;
    double on, off;
  } sheets[] = {{"davis346", 0.143, 0.225}, {"dvxplorer", 0.13, 0.13}, {"imx636", 0.25, 0.25}};
  for (const auto& [name, on, off] : sheets) {
    const SensorPreset* preset = findPreset(name);
    ASSERT_TRUE(preset) << name;
    EXPECT_NEAR(std::expm1(preset->threshold), on, 1e-4) << name;
    EXPECT_NEAR(std::expm1(preset->threshold_off), off, 1e-4) << name;
  }
}

// 99.9 % of a DVXplorer's pixels answer a contrast of 27.5 %.
TEST(Presets, HaveTheSpreadOfADataSheet) {
  const SensorPreset& preset = *findPreset("dvxplorer");
  const double C = preset.threshold, over = std::log1p(0.275) - C;
  const double share = std::erfc(-over / (preset.noise.mismatch * C) / std::numbers::sqrt2) / 2;
  EXPECT_NEAR(share, 0.999, 1e-4);
}

}  // namespace
}  // namespace saccade
