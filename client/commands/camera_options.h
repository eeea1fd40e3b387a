// The options for the camera of a stream.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "saccade/v1/control.pb.h"

namespace saccade::client {

struct CameraOptions {
  std::string size = "240x180";
  std::optional<double> fov_x_deg = {};
  std::string intrinsics = {};  // FX,FY,CX,CY
  std::string distortion = {};  // MODEL:K1,K2,...
};

// The values in `options` are the defaults.
void addCameraOptions(CLI::App& command, CameraOptions& options);

// Without a size where that is empty. Throws std::invalid_argument with the option at fault.
v1::View makeView(const CameraOptions& options);

}  // namespace saccade::client
