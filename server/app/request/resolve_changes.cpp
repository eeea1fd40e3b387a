#include <cmath>

#include "app/request/refusal.h"
#include "app/request/resolve_sensor.h"

namespace saccade {

SensorChange resolveChange(v1::SensorChange& change, const SensorConfig& config, const std::string& field) {
  checkRange(field + ".time_s", change.time_s(), ranges::kChangeTime);
  SensorChange resolved{.time = TimeNs{std::llround(change.time_s() * 1e9)}};
  if (change.has_threshold()) resolved.threshold = change.threshold();
  if (change.has_threshold_off()) resolved.threshold_off = change.threshold_off();
  if (change.has_bias()) resolved.bias = change.bias();
  if (change.has_noise()) resolved.noise = fillNoise(*change.mutable_noise(), config.noise);
  if (!resolved.threshold && !resolved.threshold_off && !resolved.bias && !resolved.noise)
    refuse(field, "changes nothing");
  if (const auto fault = findFault(changed(config, resolved)))
    refuse(field + "." + fault->field, fault->message);
  if (!resolved.noise) return resolved;
  if (const char* amount = changedPixelAmount(config.noise, *resolved.noise))
    refuse(field + ".noise." + amount, "the pixels keep what the sensor has at first");
  return resolved;
}

std::vector<SensorChange> resolveChanges(v1::Sensor& sensor, int index, const SensorConfig& config) {
  const std::string field = "sensors[" + std::to_string(index) + "].changes";
  if (sensor.changes_size() > ranges::kSensorChanges.max)
    refuse(field, "a sensor has at most " + std::to_string(ranges::kSensorChanges.max) + " changes");
  std::vector<SensorChange> changes;
  for (v1::SensorChange& change : *sensor.mutable_changes()) {
    const std::string at = field + "[" + std::to_string(changes.size()) + "]";
    const SensorChange resolved = resolveChange(change, config, at);
    if (!changes.empty() && resolved.time < changes.back().time)
      refuse(at + ".time_s", "is before the time of the change before");
    changes.push_back(resolved);
  }
  return changes;
}

}  // namespace saccade
