// The settings of a truth channel.
#pragma once

#include <string>

#include "truth/frame_selection.h"
#include "truth/imu/imu_config.h"

namespace saccade {

struct TruthConfig {
  std::string name;       // of truthTable()
  FrameSelection frames;  // for pictures: those that are wanted
  int width = 1, height = 1;
  double frame_rate_hz = 500;
  double bias = 1e-3;              // of log brightness: scene luminance
  FrameIndex exposure_frames = 1;  // of which an exposed picture is the mean
  double gain = 1, gamma = 2.2;    // of exposed pictures
  ImuConfig imu = {};
};

}  // namespace saccade
