#include <algorithm>
#include <cmath>
#include <limits>

#include "app/request/enum_names.h"
#include "app/request/refusal.h"
#include "app/request/resolve_parts.h"
#include "app/request/resolve_sensor.h"
#include "base/hash_rng.h"

namespace saccade {
namespace {

void fillDefaults(v1::Sensor& sensor, const std::string& field, std::uint64_t seed) {
  const SensorConfig defaults;
  if (!sensor.has_threshold()) sensor.set_threshold(defaults.threshold);
  if (!sensor.has_threshold_off()) sensor.set_threshold_off(sensor.threshold());
  if (!sensor.has_bias()) sensor.set_bias(defaults.bias);
  if (!sensor.has_refractory_s()) sensor.set_refractory_s(seconds(defaults.refractory));
  if (sensor.max_events_per_pixel_frame() == 0) {
    sensor.set_max_events_per_pixel_frame(defaults.max_events_per_pixel_frame);
  }
  if (!sensor.has_seed()) sensor.set_seed(seed);
  sensor.set_model(resolveEnum(field + ".model", sensor.model(),
                               valueNamed<v1::EventModel>("EVENT_MODEL_", defaults.model)));
  sensor.set_start_level(resolveEnum(field + ".start_level", sensor.start_level(), v1::START_LEVEL_RANDOM));
  sensor.set_reconstruction(
      resolveEnum(field + ".reconstruction", sensor.reconstruction(),
                  valueNamed<v1::Reconstruction>("RECONSTRUCTION_", defaults.reconstruction)));
  if (!sensor.has_cutoff_hz()) sensor.set_cutoff_hz(defaults.reconstruction_cutoff_hz);
}

}  // namespace

SensorConfig resolveSensor(v1::Sensor& sensor, int index, std::uint64_t stream_seed) {
  const std::string field = "sensors[" + std::to_string(index) + "]";
  const NoiseConfig noise = resolveNoise(sensor, field);
  fillDefaults(sensor, field, hashKey(stream_seed, static_cast<std::uint64_t>(index)));
  checkRange(field + ".refractory_s", sensor.refractory_s(), ranges::kRefractory);  // so that it fits TimeNs
  SensorConfig config;
  config.noise = noise;
  config.threshold = sensor.threshold();
  config.threshold_off = sensor.threshold_off();
  config.bias = sensor.bias();
  config.model = nameWithout("EVENT_MODEL_", v1::EventModel_Name(sensor.model()));
  config.random_start = sensor.start_level() == v1::START_LEVEL_RANDOM;
  config.reconstruction = nameWithout("RECONSTRUCTION_", v1::Reconstruction_Name(sensor.reconstruction()));
  config.reconstruction_cutoff_hz = sensor.cutoff_hz();
  config.refractory = TimeNs(std::llround(sensor.refractory_s() * 1e9));
  config.max_events_per_pixel_frame = static_cast<int>(
      std::min<std::uint32_t>(sensor.max_events_per_pixel_frame(), std::numeric_limits<int>::max()));
  config.labels = sensor.labels();
  if (sensor.has_max_artefact_odds()) config.max_artefact_odds = sensor.max_artefact_odds();
  config.seed = sensor.seed();
  if (const auto fault = findFault(config)) {
    throw Refusal(v1::CODE_INVALID_ARGUMENT, field + "." + fault->field, fault->message);
  }
  return config;
}

void resolveSensors(ResolvedStream& stream) {
  v1::OpenStream& request = stream.request;
  if (request.sensors_size() < 1 || request.sensors_size() > ranges::kSensors.max) {
    refuse("sensors", "a stream has 1 to " + std::to_string(ranges::kSensors.max) + " sensors");
  }
  for (int i = 0; i < request.sensors_size(); ++i) {
    stream.sensors.push_back(resolveSensor(*request.mutable_sensors(i), i, request.seed()));
    stream.changes.push_back(resolveChanges(*request.mutable_sensors(i), i, stream.sensors.back()));
  }
}

}  // namespace saccade
