// The topics and cameras of the sensors of a stream in one file of ROS. The first sensor of view 0 has
// /dvs/events, the next ones /dvs/events_1, /dvs/events_2; the first of view 1 has /dvs_1/events.
#pragma once

#include <string>
#include <vector>

#include "client/formats/ros/ros_camera.h"
#include "saccade/v1/recording.pb.h"

namespace saccade::client {

struct RosSensor {
  v1::Recording about;
  std::string events;              // topic
  std::string frame_id;            // of the events
  std::vector<RosCamera> cameras;  // those that no sensor before has
  std::size_t first;               // index in the file of the topic of its events; truth and cameras follow
};

// `space`: kRos1Space or kRos2Space.
std::vector<RosSensor> rosSensors(const std::vector<v1::Recording>& sensors, const std::string& space);

}  // namespace saccade::client
