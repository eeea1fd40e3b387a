// dvs_msgs/EventArray of ROS 1, as drivers of event cameras, ESIM and this program write it.
#pragma once

#include <string_view>

#include "client/formats/ros/ros_reader.h"

namespace saccade::client {

// Of the type, whatever its package: prophesee_event_msgs/EventArray is the same.
inline constexpr std::string_view kEventArrayMd5 = "5e8beee5a6c107e504c2e78903c224b8";
inline constexpr std::size_t kEventArrayEventBytes = 13;  // u16 x | u16 y | u32 s | u32 ns | u8 polarity

// Times are cut to microseconds.
class EventArrayDecoder final : public EventMessageDecoder {
 public:
  ImageSize begin(std::string_view message) override;
  bool append(Events& events) override;

 private:
  std::string_view left_;  // events that are not decoded yet
};

}  // namespace saccade::client
