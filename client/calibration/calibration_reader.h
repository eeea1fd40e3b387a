// Reads calibrations as other programs write them. Sources: github.com/ethz-asl/kalibr/wiki/yaml-formats,
// docs.ros.org/en/api/sensor_msgs (CameraInfo), docs.opencv.org (cv::FileStorage).
#pragma once

#include <string>
#include <vector>

#include "saccade/v1/control.pb.h"

namespace saccade::client {

// The cameras of a file: a camchain of Kalibr, or one camera of ROS (camera_info, as a file or as a printed
// message) or OpenCV. A size of 0 is not told. View.body_camera is set where the file tells it: of Kalibr the
// body is the IMU, or without T_cam_imu camera 0. Its lengths are metres times `units_per_metre`. Throws
// std::invalid_argument with the file, the key, and what is valid.
std::vector<v1::View> readCalibration(const std::string& path, double units_per_metre);

// Noise and rate of an imu.yaml of Kalibr. Throws likewise.
v1::Imu readImuCalibration(const std::string& path);

}  // namespace saccade::client
