#include <cmath>

#include "app/request/refusal.h"
#include "app/request/resolve.h"

namespace saccade {

SensorChange readChange(const v1::SensorChange& change, const SensorConfig& config,
                        const std::string& field) {
  checkRange(field + ".time_s", change.time_s(), ranges::kChangeTime);
  SensorChange read{.time = TimeNs{std::llround(change.time_s() * 1e9)}};
  if (change.has_threshold()) read.threshold = change.threshold();
  if (change.has_threshold_off()) read.threshold_off = change.threshold_off();
  if (change.has_bias()) read.bias = change.bias();
  if (!read.threshold && !read.threshold_off && !read.bias) refuse(field, "changes nothing");
  if (const auto fault = findFault(changed(config, read))) refuse(field + "." + fault->field, fault->message);
  return read;
}

std::vector<SensorChange> resolveChanges(const v1::Sensor& sensor, int index, const SensorConfig& config) {
  const std::string field = "sensors[" + std::to_string(index) + "].changes";
  if (sensor.changes_size() > ranges::kSensorChanges.max)
    refuse(field, "a sensor has at most " + std::to_string(ranges::kSensorChanges.max) + " changes");
  std::vector<SensorChange> changes;
  SensorConfig now = config;
  for (const v1::SensorChange& change : sensor.changes()) {
    const std::string at = field + "[" + std::to_string(changes.size()) + "]";
    const SensorChange read = readChange(change, now, at);
    if (!changes.empty() && read.time < changes.back().time)
      refuse(at + ".time_s", "is before the time of the change before");
    now = changed(now, read);
    changes.push_back(read);
  }
  return changes;
}

}  // namespace saccade
