// sensor_msgs/CameraInfo of ROS 1 and 2, for each view in a recording. Its messages have the stamps of the
// view's first frames, or else of its first other pictures, because programs pair them by equal stamps. Where
// there is none, they have those of the messages of events, as drivers of event cameras do.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "client/calibration/pinhole_camera.h"
#include "client/formats/ros/ros_truth.h"

namespace saccade::client {

constexpr int kOfEvents = -1;

struct RosCamera {
  std::uint32_t view;
  int channel;  // of Recording.truth whose stamps it has, or kOfEvents
  PinholeCamera camera;
};

// Empty where the request is not known, or is for frames of a client, whose camera nobody has told.
std::vector<RosCamera> rosCameras(const v1::Recording& about);

RosMessage rosCameraInfo1();  // of ROS 1
RosMessage rosCameraInfo2();  // of ROS 2, which has other names of fields

// The fields of the message after its header. `Message`: as of appendTruth().
template <class Message>
void appendCameraInfo(Message& message, const PinholeCamera& camera) {
  const auto numbers = [&](const std::vector<double>& values) {
    for (const double value : values) message.template number<double>(value);
  };
  message.template number<std::uint32_t>(camera.height);
  message.template number<std::uint32_t>(camera.width);
  message.text(camera.rosModel());
  message.template number<std::uint32_t>(camera.distortion.size());
  numbers(camera.distortion);
  numbers(camera.matrix());
  numbers({1, 0, 0, 0, 1, 0, 0, 0, 1});  // is its own rectified camera
  numbers(camera.projection());
  for (int i = 0; i < 6; ++i)
    message.template number<std::uint32_t>(0);  // binning and region: all of the image
  message.template number<std::uint8_t>(0);     // of which nothing is rectified
}

}  // namespace saccade::client
