// MCAP files of ROS 2 with event_camera_msgs/EventPacket of EVT3: the events of one topic.
#include "client/formats/ros/event_packet.h"
#include "client/formats/ros/mcap_source.h"

namespace saccade::client {
namespace {

std::unique_ptr<Reader> makeOf(const std::string& path, const SensorChoice& choice) {
  return std::make_unique<RosReader>(path, std::make_unique<McapSource>(path),
                                     std::make_unique<EventPacketDecoder>(path), choice);
}

std::unique_ptr<Reader> make(const std::string& path) {
  return makeOf(path, {});
}

}  // namespace

extern const ReaderInfo kMcapReader{".mcap", "ROS 2 MCAP with event_camera_msgs/EventPacket of EVT3", make,
                                    nullptr, makeOf};

}  // namespace saccade::client
