#include "client/formats/ros/bag_truth.h"

#include <algorithm>

#include "client/formats/common/ros_names.h"
#include "client/formats/common/units.h"

namespace saccade::client {
namespace {

constexpr std::int64_t kEarliestStampNs = 1;  // ros::TIME_MIN
const std::string kHeader =
    std::string(80, '=') + "\nMSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n";

}  // namespace

RosTime rosStamp(std::int64_t t_ns) {
  const std::int64_t stamp_ns = std::max(t_ns, kEarliestStampNs);
  return {static_cast<std::uint32_t>(stamp_ns / kNsPerSecond),
          static_cast<std::uint32_t>(stamp_ns % kNsPerSecond)};
}

BagTopic bagTopic(const std::string& name, const RosMessage& message) {
  return {name, message.package + "/" + message.name, message.md5sum,
          "Header header\n" + message.fields + kHeader + message.types};
}

std::vector<BagTopic> bagTruthTopics(const RosSensor& sensor) {
  const v1::Recording& about = sensor.about;
  std::vector<BagTopic> topics;
  const std::vector<std::string> names = rosTopics(about, kRos1Space);
  for (int i = 0; i < about.truth_size(); ++i)
    if (const RosMessage* message = rosMessageOf(about.truth(i)))
      topics.push_back(bagTopic(names[i], *message));
  for (const RosCamera& camera : sensor.cameras)
    topics.push_back(bagTopic(rosSpace(kRos1Space, camera.view) + "/camera_info", rosCameraInfo1()));
  return topics;
}

BagTruth::BagTruth(BagFile& file, const RosSensor& sensor) : file_(file) {
  const v1::Recording& about = sensor.about;
  std::size_t topics = sensor.first + 1;
  for (int i = 0; i < about.truth_size(); ++i) {
    const bool held = rosHolds(about.truth(i));
    channels_.push_back({about.truth(i), held ? Topic{topics++, rosFrameOf(about, i)} : Topic{}});
  }
  for (const RosCamera& camera : sensor.cameras)
    cameras_.push_back({camera, {topics++, rosFrame(camera.view)}});
}

void BagTruth::write(int channel, const TruthSamples& samples) {
  Channel& truth = channels_.at(channel);
  for (const TruthSample& sample : samples) {
    const RosTime stamp = rosStamp(sample.t_ns);
    Ros1Message message = messageAt(stamp, truth.topic);
    appendTruth(message, truth.about, sample);
    file_.add(truth.topic.number, stamp, message.bytes());
    writeCameras(channel, stamp);
  }
}

void BagTruth::writeCameras(int channel, const RosTime& stamp) {
  for (Camera& camera : cameras_) {
    if (camera.about.channel != channel) continue;
    Ros1Message message = messageAt(stamp, camera.topic);
    appendCameraInfo(message, camera.about.camera);
    file_.add(camera.topic.number, stamp, message.bytes());
  }
}

Ros1Message BagTruth::messageAt(const RosTime& stamp, Topic& topic) {
  Ros1Message message;
  for (const std::uint32_t number : {topic.sequence++, stamp.sec, stamp.nsec})
    message.number<std::uint32_t>(number);
  message.text(topic.frame_id);
  return message;
}

}  // namespace saccade::client
