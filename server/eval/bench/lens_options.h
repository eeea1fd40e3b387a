// The options for intrinsics and distortion of a camera.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "scene/camera/camera_model.h"

namespace saccade::eval {

struct LensOptions {
  std::vector<double> intrinsics = {};  // fx, fy, cx, cy; or none
  std::string distortion = {};          // MODEL:K1,K2,...; or none
};

void addLensOptions(CLI::App& app, LensOptions& options);

// `camera` with what the options say. Throws CLI::ValidationError with the valid values.
CameraModel withLens(CameraModel camera, const LensOptions& options);

}  // namespace saccade::eval
