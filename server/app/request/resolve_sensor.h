// Resolves the sensors of a request.
#pragma once

#include <string>
#include <vector>

#include "events/sensor_config.h"
#include "saccade/v1/control.pb.h"

namespace saccade {

// Fills in the noise of a sensor, and with a preset the values of that camera. `field`: the path of the
// sensor. Throws Refusal.
NoiseConfig resolveNoise(v1::Sensor& sensor, const std::string& field);
// Fills in the fields of `noise` that are unset, and returns all of them.
NoiseConfig fillNoise(v1::Noise& noise, const NoiseConfig& defaults);

// Checks sensor `index` and fills in its defaults. Throws Refusal.
SensorConfig resolveSensor(v1::Sensor& sensor, int index, std::uint64_t stream_seed);

// Checks the changes of sensor `index`, which resolveSensor() has made `config`, and fills in their noise.
// Throws Refusal.
std::vector<SensorChange> resolveChanges(v1::Sensor& sensor, int index, const SensorConfig& config);
// The same for one change. Throws Refusal naming a member of `field`.
SensorChange resolveChange(v1::SensorChange& change, const SensorConfig& config, const std::string& field);

}  // namespace saccade
