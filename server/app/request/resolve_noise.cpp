#include <optional>

#include "app/request/refusal.h"
#include "app/request/resolve_sensor.h"
#include "base/text_cut.h"
#include "events/noise/presets.h"

namespace saccade {
namespace {

std::optional<double> given(bool is_set, double value) {
  return is_set ? std::optional(value) : std::nullopt;
}

}  // namespace

NoiseConfig fillNoise(v1::Noise& noise, const NoiseConfig& defaults) {
  NoiseConfig config;
  for (const NoiseField& row : noiseFields()) {
    const auto* field = v1::Noise::descriptor()->FindFieldByName(row.name);
    const auto* reflection = noise.GetReflection();
    if (!reflection->HasField(noise, field)) reflection->SetDouble(&noise, field, defaults.*row.value);
    config.*row.value = reflection->GetDouble(noise, field);
  }
  return config;
}

NoiseConfig resolveNoise(v1::Sensor& sensor, const std::string& field) {
  if (sensor.preset().empty()) {
    return sensor.has_noise() ? fillNoise(*sensor.mutable_noise(), {}) : NoiseConfig{};
  }
  const SensorPreset* preset = findPreset(sensor.preset());
  if (!preset)
    refuse(field + ".preset",
           "there is no preset '" + cutText(sensor.preset(), kMaxEcho) + "'; there are: " + presetNames());
  const auto [on, off] = thresholdsOf(*preset, given(sensor.has_threshold(), sensor.threshold()),
                                      given(sensor.has_threshold_off(), sensor.threshold_off()));
  sensor.set_threshold(on), sensor.set_threshold_off(off);
  if (!sensor.has_refractory_s()) sensor.set_refractory_s(preset->refractory_s);
  return fillNoise(*sensor.mutable_noise(), preset->noise);
}

}  // namespace saccade
