// The flags of a sensor.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "events/sensor_config.h"

namespace CLI {
class App;
}

namespace saccade::eval {

struct SensorOptions {
  // Without a value: that of the preset, or the default.
  std::optional<double> threshold, threshold_off, refractory_s;
  std::string model = SensorConfig{}.model;  // a name of eventModelTable()
  std::string preset;                        // a name of sensorPresets(), or empty
  std::vector<std::string> noise;            // "KEY=VALUE" each
  double bias = SensorConfig{}.bias;
  std::uint64_t seed = 0;
};

void addSensorOptions(CLI::App& app, SensorOptions& o);

// Fills in what the flags leave open, as the server does. Throws CLI::ValidationError, std::runtime_error.
SensorConfig configOf(const SensorOptions& o);

}  // namespace saccade::eval
