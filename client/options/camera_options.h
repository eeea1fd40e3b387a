// The options for the camera of a stream.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "saccade/v1/control.pb.h"

namespace saccade::client {

struct CameraOptions {
  std::string size = {};                 // WIDTHxHEIGHT
  std::string default_size = "240x180";  // where neither `size` nor `calibration` tells it; empty: none
  std::optional<double> fov_x_deg = {};
  std::string intrinsics = {};   // FX,FY,CX,CY
  std::string distortion = {};   // MODEL:K1,K2,...
  std::string calibration = {};  // a file, see calibration_reader.h
};

// The values in `options` are the defaults.
void addCameraOptions(CLI::App& command, CameraOptions& options);

// The cameras of the calibration, or one camera. Without a size where nothing tells it. Lengths of the file
// are `units_per_metre` scene units. Throws std::invalid_argument with the option at fault.
std::vector<v1::View> makeViews(const CameraOptions& options, double units_per_metre);

// Empty, or a sentence that tells which size intrinsics are taken with.
std::string sizeNote(const CameraOptions& options);

}  // namespace saccade::client
