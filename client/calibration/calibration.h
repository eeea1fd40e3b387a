// The calibration of the cameras and the IMU of a recording, as files of other programs have it. The numbers
// are those with which the events were rendered. Sources: github.com/ethz-asl/kalibr/wiki/yaml-formats,
// dsec.ifi.uzh.ch/data-format.
#pragma once

#include <string>
#include <vector>

#include "saccade/v1/control.pb.h"

namespace saccade::client {

struct CalibrationFile {
  std::string name;  // "events.csv.kalibr.yaml" beside events.csv
  std::string text;
};

// The files beside the recording `path`, of a request without defaults, as StreamOpened.resolved has it. View
// n is the camera camn.
//   camera_info.yaml, cam1.camera_info.yaml, ...  sensor_msgs/CameraInfo, as camera_calibration_parsers of
//                                                 ROS reads it
//   kalibr.yaml       a camchain of Kalibr, with T_cam_imu where a truth channel is the IMU
//   imu.yaml          where a truth channel is the IMU: its noise, as Kalibr has it
//   cam_to_cam.yaml   beside .h5 alone: as DSEC has it, each camera being its own rectified one
// Lengths are metres of the IMU, and without one scene units.
std::vector<CalibrationFile> calibrationFiles(const std::string& path, const v1::OpenStream& stream);

// Empty, or why the views have no such files: Kalibr and DSEC know no k3.
std::string calibrationFault(const v1::OpenStream& stream);

}  // namespace saccade::client
