#include "app/request/refusal.h"
#include "app/request/resolve.h"

namespace saccade {

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
  if (!preset) refuse(field + ".preset", "there is no such preset; there are: " + presetNames());
  if (!sensor.has_threshold_off() && !sensor.has_threshold()) sensor.set_threshold_off(preset->threshold_off);
  if (!sensor.has_threshold()) sensor.set_threshold(preset->threshold);
  if (!sensor.has_refractory_s()) sensor.set_refractory_s(preset->refractory_s);
  return fillNoise(*sensor.mutable_noise(), preset->noise);
}

}  // namespace saccade
