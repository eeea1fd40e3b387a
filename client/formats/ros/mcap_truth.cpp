#include "client/formats/ros/mcap_truth.h"

#include "client/formats/common/ros_names.h"
#include "client/formats/common/units.h"

namespace saccade::client {
namespace {

const std::string kRule = std::string(80, '=') + "\n";
const std::string kHeader = kRule +
                            "MSG: std_msgs/Header\n"
                            "builtin_interfaces/Time stamp\n"
                            "string frame_id\n" +
                            kRule +
                            "MSG: builtin_interfaces/Time\n"
                            "int32 sec\n"
                            "uint32 nanosec\n";

}  // namespace

void appendHeader(CdrMessage& message, std::int64_t t_ns, std::string_view frame_id) {
  message.number<std::int32_t>(t_ns / kNsPerSecond);
  message.number<std::uint32_t>(t_ns % kNsPerSecond);
  message.text(frame_id);
}

McapChannel mcapChannel(const std::string& topic, const RosMessage& message) {
  return {.topic = topic,
          .encoding = "cdr",
          .metadata_key = "offered_qos_profiles",
          .schema_name = message.package + "/msg/" + message.name,
          .schema_encoding = "ros2msg",
          .schema = "std_msgs/Header header\n" + message.fields + kHeader + message.types};
}

std::vector<McapChannel> mcapTruthChannels(const RosSensor& sensor) {
  const v1::Recording& about = sensor.about;
  std::vector<McapChannel> channels;
  const std::vector<std::string> topics = rosTopics(about, kRos2Space);
  for (int i = 0; i < about.truth_size(); ++i)
    if (const RosMessage* message = rosMessageOf(about.truth(i)))
      channels.push_back(mcapChannel(topics[i], *message));
  for (const RosCamera& camera : sensor.cameras)
    channels.push_back(mcapChannel(rosSpace(kRos2Space, camera.view) + "/camera_info", rosCameraInfo2()));
  return channels;
}

McapTruth::McapTruth(McapFile& file, const RosSensor& sensor) : file_(file) {
  const v1::Recording& about = sensor.about;
  std::size_t channels = sensor.first + 1;
  for (int i = 0; i < about.truth_size(); ++i) {
    const bool held = rosHolds(about.truth(i));
    channels_.push_back({about.truth(i), held ? rosFrameOf(about, i) : "", held ? channels++ : 0});
  }
  for (const RosCamera& camera : sensor.cameras) cameras_.push_back({camera, channels++});
}

void McapTruth::write(int channel, const TruthSamples& samples) {
  const Channel& truth = channels_.at(channel);
  for (const TruthSample& sample : samples) {
    CdrMessage message;
    appendHeader(message, sample.t_ns, truth.frame_id);
    appendTruth(message, truth.about, sample);
    file_.add(truth.number, sample.t_ns, message.bytes());
    writeCameras(channel, sample.t_ns, sample.t_ns);
  }
}

void McapTruth::writeCameras(int channel, std::int64_t stamp_ns, std::int64_t log_ns) {
  for (const Camera& camera : cameras_) {
    if (camera.about.channel != channel) continue;
    CdrMessage message;
    appendHeader(message, stamp_ns, rosFrame(camera.about.view));
    appendCameraInfo(message, camera.about.camera);
    file_.add(camera.number, log_ns, message.bytes());
  }
}

}  // namespace saccade::client
