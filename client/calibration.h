// The calibration of the camera of a recording, as files of other programs have it. The numbers are those
// with which the events were rendered.
#pragma once

#include <string>
#include <vector>

#include "saccade/v1/control.pb.h"

namespace saccade::client {

struct CalibrationFile {
  std::string name;  // "events.csv.kalibr.yaml" beside events.csv
  std::string text;
};

// The files beside the recording `path`, of a view without defaults, as StreamOpened.resolved has it:
//   camera_info.yaml  sensor_msgs/CameraInfo, as camera_calibration_parsers of ROS reads it
//   kalibr.yaml       a camchain of Kalibr
//   cam_to_cam.yaml   beside .h5 alone: as DSEC has it, one camera that is its own rectified one
std::vector<CalibrationFile> calibrationFiles(const std::string& path, const v1::View& view);

// Empty, or why a view has no such files: Kalibr and DSEC know no k3.
std::string calibrationFault(const v1::View& view);

}  // namespace saccade::client
