// The command line of `saccade record` and the request it stands for.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "client/commands/commands.h"
#include "saccade/v1/control.pb.h"

namespace saccade::client {

// What is not given is left to the server's defaults.
struct RecordOptions {
  ServerOptions server;
  std::string scene, output, preview;
  std::string trajectory, motion;  // one of them
  std::optional<double> turn_s;
  std::uint64_t motion_seed = 0;
  std::vector<double> thresholds, thresholds_off;  // one sensor for each threshold
  std::optional<double> bias, refractory_s, cutoff_hz, fov_x_deg;
  std::string model, reconstruction;
  std::string size = "346x260";
  double rate_hz = 500, duration_s = 2;
  std::string delivery = "lossless", clock = "fast";
  std::string codec;
  double retry_time_s = 60;
  std::string method;
  std::optional<std::uint32_t> spp, bounces;
  bool jitter = false;
  std::optional<double> budget_ms, max_false_rate;
  std::string max_event_change;                // "2%"
  std::vector<std::string> disabled_features;  // parts of the scene's model
  std::vector<std::string> params;             // name=value
  std::uint64_t seed = 0;
};

void addRecordOptions(CLI::App& command, RecordOptions& options);

// Adds the valid range to the help of each number of the request.
void sayRanges(CLI::App& record);

// Reads the trajectory's file where one is named. Both throw std::invalid_argument naming the option at
// fault.
v1::Trajectory makeTrajectory(const RecordOptions& options);
v1::OpenStream makeOpenStream(const RecordOptions& options);

}  // namespace saccade::client
