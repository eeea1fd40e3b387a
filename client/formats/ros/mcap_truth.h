// The channels of a sensor in an MCAP file beside that of its events: truth, and the cameras.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "client/formats/ros/cdr.h"
#include "client/formats/ros/mcap_file.h"
#include "client/formats/ros/ros_sensors.h"

namespace saccade::client {

// Starts a message of ROS 2 with its std_msgs/Header.
void appendHeader(CdrMessage& message, std::int64_t t_ns, std::string_view frame_id);

McapChannel mcapChannel(const std::string& topic, const RosMessage& message);

// Those of the sensor, without that of its events.
std::vector<McapChannel> mcapTruthChannels(const RosSensor& sensor);

class McapTruth {
 public:
  // `file` has the channel of the sensor's events, and then mcapTruthChannels().
  McapTruth(McapFile& file, const RosSensor& sensor);

  void write(int channel, const TruthSamples& samples);
  // The cameras that go with a message of a truth channel, or of kOfEvents.
  void writeCameras(int channel, std::int64_t stamp_ns, std::int64_t log_ns);

 private:
  struct Channel {
    v1::RecordedTruth about;
    std::string frame_id;
    std::size_t number;  // in the file
  };
  struct Camera {
    RosCamera about;
    std::size_t number;  // in the file
  };

  McapFile& file_;
  std::vector<Channel> channels_;
  std::vector<Camera> cameras_;
};

}  // namespace saccade::client
