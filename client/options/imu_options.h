// The options for the IMU, which is the truth channel imu.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "saccade/v1/control.pb.h"

namespace saccade::client {

struct ImuOptions {
  std::vector<std::string> settings = {};  // KEY=NUMBER, or the path of an imu.yaml of Kalibr
  std::string gravity = {};                // X,Y,Z
  std::string up = {};                     // an axis of the world
};

void addImuOptions(CLI::App& command, ImuOptions& options);

// Sets the channels imu of the request. Throws std::invalid_argument with the option at fault, which may be
// that there is no such channel.
void setImu(const ImuOptions& options, std::optional<double> metres_per_unit, v1::OpenStream& open);

}  // namespace saccade::client
