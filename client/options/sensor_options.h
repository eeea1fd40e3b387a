// The options of sensors on the command line, and the sensors that they ask for.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "saccade/v1/control.pb.h"

namespace saccade::client {

// Options that are not given are left to the server's defaults.
struct SensorOptions {
  std::vector<double> thresholds, thresholds_off;  // one sensor for each threshold
  std::optional<double> bias, refractory_s, cutoff_hz;
  std::string model, start_level, reconstruction, preset;
  std::vector<std::string> noise;  // name=value
  std::optional<double> max_artefact_odds;
  std::optional<std::uint32_t> max_events;  // of a pixel in an interval
};

void addSensorOptions(CLI::App& command, SensorOptions& options);
void limitSensors(CLI::App& command);  // each number must lie in its range, which its help says

// Adds a sensor to the request for each threshold. Throws std::invalid_argument with the option at fault.
void addSensors(const SensorOptions& options, v1::OpenStream& open);

}  // namespace saccade::client
