// The topics of a sensor in a bag beside that of its events: truth channels, and the cameras.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "client/formats/ros/bag_file.h"
#include "client/formats/ros/ros1_message.h"
#include "client/formats/ros/ros_sensors.h"

namespace saccade::client {

// Stamps begin at 1 ns, because ROS takes 0 for "no time".
RosTime rosStamp(std::int64_t t_ns);

BagTopic bagTopic(const std::string& name, const RosMessage& message);

// Those of the sensor, without that of its events.
std::vector<BagTopic> bagTruthTopics(const RosSensor& sensor);

class BagTruth {
 public:
  // `file` has the topic of the sensor's events, and then bagTruthTopics().
  BagTruth(BagFile& file, const RosSensor& sensor);

  void write(int channel, const TruthSamples& samples);
  // The cameras that go with a message of a truth channel, or of kOfEvents.
  void writeCameras(int channel, const RosTime& stamp);

 private:
  struct Topic {
    std::size_t number;
    std::string frame_id;
    std::uint32_t sequence = 0;
  };
  struct Channel {
    v1::RecordedTruth about;
    Topic topic;
  };
  struct Camera {
    RosCamera about;
    Topic topic;
  };

  static Ros1Message messageAt(const RosTime& stamp, Topic& topic);

  BagFile& file_;
  std::vector<Channel> channels_;
  std::vector<Camera> cameras_;
};

}  // namespace saccade::client
