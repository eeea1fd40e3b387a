// event_camera_msgs/EventPacket of ROS 2 with EVT3, as drivers of event cameras and this program write it.
#pragma once

#include <optional>
#include <string_view>

#include "client/formats/evt/evt_decoder.h"
#include "client/formats/ros/ros_reader.h"

namespace saccade::client {

inline constexpr std::string_view kEventPacket2 = "event_camera_msgs/msg/EventPacket";

// Times are those of EVT3, which wrap every 16.8 s. Wraps before the first event count where that has the
// time of its message's stamp, as this program writes it. Drivers stamp with another clock.
class EventPacketDecoder final : public EventMessageDecoder {
 public:
  explicit EventPacketDecoder(const std::string& path);  // for errors

  ImageSize begin(std::string_view message) override;
  bool append(Events& events) override;

 private:
  const std::unique_ptr<EvtDecoder> decoder_;
  std::string_view left_;                  // words that are not decoded yet
  std::int64_t stamp_us_ = 0;              // of the message
  std::optional<std::int64_t> before_ns_;  // wraps before the first event, once there is one
};

}  // namespace saccade::client
