// Truth channels as messages of ROS 1 and 2: pictures as sensor_msgs/Image, and the rows of `pose`,
// `velocity` and `imu` as geometry_msgs/PoseStamped, geometry_msgs/TwistStamped and sensor_msgs/Imu.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "client/formats/common/truth_layout.h"
#include "saccade/wire/truth_samples.h"

namespace saccade::client {

struct RosMessage {
  std::string package, name;  // "sensor_msgs", "Image"
  std::string md5sum;         // of ROS 1
  std::string fields;         // that follow the header
  std::string types;          // definitions of the types that the fields use
  std::string frame_id;       // empty: that of the camera
};

// The message that holds the samples; nullptr: there is none.
const RosMessage* rosMessageOf(const v1::RecordedTruth& channel);
inline bool rosHolds(const v1::RecordedTruth& channel) {
  return rosMessageOf(channel) != nullptr;
}

// The frame of about.truth(channel), which has a message.
std::string rosFrameOf(const v1::Recording& about, int channel);

std::string rosEncoding(const v1::RecordedTruth& channel);  // of sensor_msgs/Image
std::vector<double> rosNumbers(const v1::RecordedTruth& channel,
                               const TruthSample& sample);  // of other messages

// The fields of the message after its header. `Message` is Ros1Message, or CdrMessage of ROS 2.
template <class Message>
void appendTruth(Message& message, const v1::RecordedTruth& channel, const TruthSample& sample) {
  if (!isPicture(channel)) {
    for (const double number : rosNumbers(channel, sample)) message.template number<double>(number);
    return;
  }
  message.template number<std::uint32_t>(channel.height());
  message.template number<std::uint32_t>(channel.width());
  message.text(rosEncoding(channel));
  message.template number<std::uint8_t>(0);  // is_bigendian
  message.template number<std::uint32_t>(sampleBytes(channel) / channel.height());
  message.octets(interleaved(channel, sample.elements));
}

}  // namespace saccade::client
