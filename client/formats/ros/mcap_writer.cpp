// An MCAP file of ROS 2 with event_camera_msgs/EventPacket, whose events are EVT3. A message covers up to
// 5 ms. Its header has the time of its first event, and the file's log has that of its last. Each message
// starts with TIME_HIGH, TIME_LOW and ADDR_Y, so that a lost message costs only itself. TIME_HIGH wraps every
// 16.8 s: in silence, a message with a time but no events follows every 8 s, less than half of
// that. Samples of truth and
// the numbers of cameras have channels of their own, and so have further sensors.
#include <memory>
#include <stdexcept>
#include <utility>

#include "client/formats/common/message_splitter.h"
#include "client/formats/common/ros_names.h"
#include "client/formats/common/shared_file.h"
#include "client/formats/common/units.h"
#include "client/formats/common/writer.h"
#include "client/formats/evt/evt3_encoder.h"
#include "client/formats/ros/mcap_truth.h"

namespace saccade::client {
namespace {

constexpr std::int64_t kMaxSilenceNs = 8 * kNsPerSecond;
constexpr std::string_view kEncoding = "evt3";

const RosMessage kEventPacket{"event_camera_msgs",
                              "EventPacket",
                              "",  // ROS 2 has no such sum
                              "uint32 height\n"
                              "uint32 width\n"
                              "uint64 seq\n"
                              "uint64 time_base\n"
                              "string encoding\n"
                              "bool is_bigendian\n"
                              "uint8[] events\n",
                              "",
                              ""};

std::vector<McapChannel> channelsOf(const std::vector<RosSensor>& sensors) {
  std::vector<McapChannel> channels;
  for (const RosSensor& sensor : sensors) {
    channels.push_back(mcapChannel(sensor.events, kEventPacket));
    for (const McapChannel& channel : mcapTruthChannels(sensor)) channels.push_back(channel);
  }
  return channels;
}

using SharedMcap = SharedFile<McapFile>;

class McapWriter : public Writer {
 public:
  McapWriter(std::shared_ptr<SharedMcap> shared, const RosSensor& sensor)
      : shared_(std::move(shared)),
        truth_(shared_->file(), sensor),
        channel_(sensor.first),
        width_(sensor.about.width()),
        height_(sensor.about.height()),
        frame_id_(sensor.frame_id),
        encoder_(width_) {}

  void write(const Events& events, std::int64_t until_ns) override { splitter_.add(events, until_ns); }
  void writeTruth(int channel, const TruthSamples& samples) override { truth_.write(channel, samples); }
  void finish() override {
    splitter_.flush();
    shared_->finish();
  }
  std::uint64_t kept(std::uint64_t) const override { return shared_->file().kept(channel_); }

 private:
  void writeMessage(const Events& events) {
    const std::int64_t begin_ns = events.front().t_ns;
    if (begin_ns < 0 || events.back().t_ns >= (std::int64_t{INT32_MAX} + 1) * kNsPerSecond)
      throw std::range_error("ROS 2 holds times from 0 to 2147483647 s, and an event is at " +
                             std::to_string(begin_ns / 1e9) + " s");
    fillSilence(begin_ns);
    encoder_.restart(begin_ns / kNsPerUs);
    encoder_.encode(events);
    writePacket(begin_ns, events.back().t_ns, events.size());
  }

  // Writes messages without events between the last message and `until_ns`.
  void fillSilence(std::int64_t until_ns) {
    while (sequence_ > 0 && until_ns - told_ns_ > kMaxSilenceNs) {
      const std::int64_t t_ns = told_ns_ + kMaxSilenceNs;
      encoder_.restart(t_ns / kNsPerUs);
      encoder_.encodeTime(t_ns / kNsPerUs);
      writePacket(t_ns, t_ns, 0);
    }
  }

  void writePacket(std::int64_t begin_ns, std::int64_t end_ns, std::size_t events) {
    message_.clear();
    appendHeader(message_, begin_ns, frame_id_);
    message_.number<std::uint32_t>(height_);
    message_.number<std::uint32_t>(width_);
    message_.number<std::uint64_t>(sequence_++);
    message_.number<std::uint64_t>(0);  // time_base, which evt3 does not use
    message_.text(kEncoding);
    message_.number<std::uint8_t>(0);  // is_bigendian
    message_.octets(encoder_.bytes());
    encoder_.clear();
    shared_->file().add(channel_, end_ns, message_.bytes(), events);
    truth_.writeCameras(kOfEvents, begin_ns, end_ns);
    told_ns_ = end_ns;
  }

  const std::shared_ptr<SharedMcap> shared_;
  McapTruth truth_;
  MessageSplitter splitter_{[this](const Events& events) { writeMessage(events); }};
  const std::size_t channel_;  // of the events
  const std::uint32_t width_, height_;
  const std::string frame_id_;
  Evt3Encoder encoder_;
  CdrMessage message_;
  std::uint64_t sequence_ = 0;  // of the next message
  std::int64_t told_ns_ = 0;    // end of the last message
};

void checkSize(const v1::Recording& about) {
  if (about.width() > kEvtEdge || about.height() > kEvtEdge)
    throw std::invalid_argument("mcap holds images of at most 2048x2048 pixels, as EVT3 does, not " +
                                std::to_string(about.width()) + "x" + std::to_string(about.height()));
}

Writers makeJoint(const std::string& path, const std::vector<v1::Recording>& recordings) {
  for (const v1::Recording& about : recordings) checkSize(about);
  const std::vector<RosSensor> sensors = rosSensors(recordings, kRos2Space);
  const auto shared = std::make_shared<SharedMcap>(sensors.size(), path, "ros2", channelsOf(sensors));
  Writers writers;
  for (const RosSensor& sensor : sensors) writers.push_back(std::make_unique<McapWriter>(shared, sensor));
  return writers;
}

std::unique_ptr<Writer> make(const std::string& path, const v1::Recording& about) {
  return std::move(makeJoint(path, {about}).front());
}

}  // namespace

extern const WriterInfo kMcapWriter{"mcap", ".mcap",  "ROS 2 MCAP with event_camera_msgs/EventPacket",
                                    make,   false,    rosHolds,
                                    false,  makeJoint};

}  // namespace saccade::client
