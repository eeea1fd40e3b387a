// The readers of one kind of calibration each, and what they share. See calibration_reader.h.
#pragma once

#include <string>
#include <vector>

#include "client/calibration/yaml_file.h"
#include "saccade/v1/control.pb.h"

namespace saccade::client {

std::vector<v1::View> readKalibr(const YamlMapping& file, double units_per_metre);
v1::View readCameraInfo(const YamlMapping& file);  // of ROS or OpenCV

// `key`: of the numbers in the file, for errors.
void setSize(const YamlMapping& file, const std::string& key, double width, double height, v1::View& view);
void setIntrinsics(double fx, double fy, double cx, double cy, v1::View& view);
// Zeros beyond the coefficients of the model are left out.
void setDistortion(const YamlMapping& file, const std::string& key, v1::DistortionModel model,
                   std::vector<double> coefficients, v1::View& view);

}  // namespace saccade::client
