// An MCAP file of ROS 2 with event_camera_msgs/EventPacket, whose events are EVT3. A message covers up to
// 5 ms. Its header has the time of its first event, and the file's log has that of its last. Each message
// starts with TIME_HIGH, TIME_LOW and ADDR_Y, so that a lost message costs only itself. TIME_HIGH wraps every
// 16.8 s: in silence, a message with a time but no events follows every 10 s. Samples of truth and
// the numbers of cameras have channels of their own.
#include <stdexcept>

#include "client/stream_views.h"
#include "client/units.h"
#include "client/writers/evt3_encoder.h"
#include "client/writers/mcap_truth.h"
#include "client/writers/message_splitter.h"
#include "client/writers/ros_names.h"
#include "client/writers/writer.h"

namespace saccade::client {
namespace {

constexpr std::int64_t kMaxSilenceNs = 10 * kNsPerSecond;
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

std::vector<McapChannel> channelsOf(const v1::Recording& about) {
  std::vector<McapChannel> channels{
      mcapChannel(rosSpace(kRos2Space, viewOfEvents(about)) + "/events", kEventPacket)};
  for (const McapChannel& channel : mcapTruthChannels(about)) channels.push_back(channel);
  return channels;
}

class McapWriter : public Writer {
 public:
  McapWriter(const std::string& path, const v1::Recording& about)
      : file_(path, "ros2", channelsOf(about)),
        truth_(file_, about),
        width_(about.width()),
        height_(about.height()),
        frame_id_(rosFrame(viewOfEvents(about))),
        encoder_(width_) {}

  void write(const Events& events, std::int64_t until_ns) override { splitter_.add(events, until_ns); }
  void writeTruth(int channel, const TruthSamples& samples) override { truth_.write(channel, samples); }
  void finish() override {
    splitter_.flush();
    file_.finish();
  }

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
    file_.add(0, end_ns, message_.bytes(), events);
    truth_.writeCameras(kOfEvents, begin_ns, end_ns);
    told_ns_ = end_ns;
  }

  McapFile file_;
  McapTruth truth_;
  MessageSplitter splitter_{[this](const Events& events) { writeMessage(events); }};
  const std::uint32_t width_, height_;
  const std::string frame_id_;
  Evt3Encoder encoder_;
  CdrMessage message_;
  std::uint64_t sequence_ = 0;  // of the next message
  std::int64_t told_ns_ = 0;    // end of the last message
};

std::unique_ptr<Writer> make(const std::string& path, const v1::Recording& about) {
  if (about.width() > kEvtEdge || about.height() > kEvtEdge)
    throw std::invalid_argument("mcap holds images of at most 2048x2048 pixels, as EVT3 does, not " +
                                std::to_string(about.width()) + "x" + std::to_string(about.height()));
  return std::make_unique<McapWriter>(path, about);
}

}  // namespace

const WriterInfo kMcapWriter{"mcap", ".mcap", "ROS 2 MCAP with event_camera_msgs/EventPacket",
                             make,   false,   rosHolds};

}  // namespace saccade::client
