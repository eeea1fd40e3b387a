// The part of a camera with its lens that Kalibr and DSEC write alike.
#pragma once

#include <string>

#include "client/calibration/pinhole_camera.h"
#include "client/calibration/yaml.h"

namespace saccade::client {

// Lines after `indent`.
inline std::string resolutionYaml(const PinholeCamera& camera, const std::string& indent) {
  return indent + "resolution: [" + std::to_string(camera.width) + ", " + std::to_string(camera.height) +
         "]\n";
}

// The same. `matrix`: the name of the four intrinsics.
inline std::string lensYaml(const PinholeCamera& camera, const std::string& indent,
                            const std::string& matrix) {
  const std::vector<double> four(camera.distortion.begin(), camera.distortion.begin() + 4);
  return indent + "camera_model: pinhole\n" + indent + matrix + ": " + yamlList(camera.intrinsics()) + "\n" +
         indent + "distortion_model: " + camera.kalibrModel() + "\n" + indent +
         "distortion_coeffs: " + yamlList(four) + "\n" + resolutionYaml(camera, indent);
}

}  // namespace saccade::client
