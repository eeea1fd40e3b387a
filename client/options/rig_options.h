// The options for the body that carries the cameras.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "saccade/v1/control.pb.h"

namespace saccade::client {

struct RigOptions {
  std::string body_camera = {};                 // X,Y,Z or X,Y,Z,QX,QY,QZ,QW: T_body_camera of view 0
  std::vector<std::string> further_views = {};  // the same, in the axes of view 0
  std::optional<double> metres_per_unit = {};   // of a calibration and of the IMU
};

void addRigOptions(CLI::App& command, RigOptions& options);

// Adds the cameras `views`, at least one, and those of the options to the request. Each further one has
// sensors of its own like those of `open`. Throws std::invalid_argument with the option at fault.
void addViews(const RigOptions& options, const std::vector<v1::View>& views, v1::OpenStream& open);

}  // namespace saccade::client
