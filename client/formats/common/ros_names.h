// Topics and frames in ROS. View n has its own, so that one file holds several views:
// /dvs/events and camera for view 0, /dvs_1/events and camera_1 for view 1.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "saccade/v1/recording.pb.h"

namespace saccade::client {

constexpr const char *kRos1Space = "/dvs", *kRos2Space = "/event_camera";

std::string rosSpace(const std::string& space, std::uint32_t view);  // "/dvs", "/dvs_1"
std::string rosFrame(std::uint32_t view);                            // "camera", "camera_1"

// By truth channel of the recording, topics in the space of its view: image_raw for the first of `frame` and
// `frame16`, else the channel's name.
std::vector<std::string> rosTopics(const v1::Recording& about, const std::string& space);

}  // namespace saccade::client
