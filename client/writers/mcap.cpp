// An MCAP file of ROS 2 with event_camera_msgs/EventPacket, whose events are EVT3. A message covers up to
// 5 ms. Its header has the time of its first event, and the file's log has that of its last. Each message
// starts with TIME_HIGH, TIME_LOW and ADDR_Y, so that a lost message costs only itself. TIME_HIGH wraps every
// 16.8 s: in silence, a message with a time but no events follows every 10 s. Samples of truth have channels
// of their own.
#include <stdexcept>

#include "client/units.h"
#include "client/writers/cdr.h"
#include "client/writers/evt3_encoder.h"
#include "client/writers/mcap_file.h"
#include "client/writers/message_splitter.h"
#include "client/writers/ros_truth.h"
#include "client/writers/writer.h"

namespace saccade::client {
namespace {

constexpr std::int64_t kMaxSilenceNs = 10 * kNsPerSecond;
constexpr std::string_view kFrameId = "camera", kEncoding = "evt3";

const std::string kRule = std::string(80, '=') + "\n";
const std::string kHeader = kRule +
                            "MSG: std_msgs/Header\n"
                            "builtin_interfaces/Time stamp\n"
                            "string frame_id\n" +
                            kRule +
                            "MSG: builtin_interfaces/Time\n"
                            "int32 sec\n"
                            "uint32 nanosec\n";

const McapChannel kChannel{.topic = "/event_camera/events",
                           .encoding = "cdr",
                           .metadata_key = "offered_qos_profiles",
                           .schema_name = "event_camera_msgs/msg/EventPacket",
                           .schema_encoding = "ros2msg",
                           .schema =
                               "std_msgs/Header header\n"
                               "uint32 height\n"
                               "uint32 width\n"
                               "uint64 seq\n"
                               "uint64 time_base\n"
                               "string encoding\n"
                               "bool is_bigendian\n"
                               "uint8[] events\n" +
                               kHeader};

// The channel of the events, and those of truth.
std::vector<McapChannel> channelsOf(const v1::Recording& about) {
  std::vector<McapChannel> channels{kChannel};
  const std::vector<std::string> topics = rosTopics(about, "/event_camera");
  for (int i = 0; i < about.truth_size(); ++i) {
    const RosMessage* message = rosMessageOf(about.truth(i));
    if (!message) continue;
    McapChannel channel = kChannel;
    channel.topic = topics[i];
    channel.schema_name = message->package + "/msg/" + message->name;
    channel.schema = "std_msgs/Header header\n" + message->fields + kHeader + message->types;
    channels.push_back(channel);
  }
  return channels;
}

class McapWriter : public Writer {
 public:
  McapWriter(const std::string& path, const v1::Recording& about)
      : file_(path, "ros2", channelsOf(about)),
        width_(about.width()),
        height_(about.height()),
        encoder_(width_) {
    for (const v1::RecordedTruth& channel : about.truth())
      truth_.push_back({channel, rosHolds(channel) ? ++channels_ : 0});
  }

  void write(const Events& events, std::int64_t until_ns) override { splitter_.add(events, until_ns); }
  void writeTruth(int channel, const TruthSamples& samples) override {
    const Truth& truth = truth_.at(channel);
    for (const TruthSample& sample : samples) {
      CdrMessage message;
      appendHeader(message, sample.t_ns, rosMessageOf(truth.about)->frame_id);
      appendTruth(message, truth.about, sample);
      file_.add(truth.channel, sample.t_ns, message.bytes());
    }
  }
  void finish() override {
    splitter_.flush();
    file_.finish();
  }

 private:
  struct Truth {
    v1::RecordedTruth about;
    std::size_t channel;  // of the file
  };

  static void appendHeader(CdrMessage& message, std::int64_t t_ns, std::string_view frame_id) {
    message.number<std::int32_t>(t_ns / kNsPerSecond);
    message.number<std::uint32_t>(t_ns % kNsPerSecond);
    message.text(frame_id);
  }

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
    appendHeader(message_, begin_ns, kFrameId);
    message_.number<std::uint32_t>(height_);
    message_.number<std::uint32_t>(width_);
    message_.number<std::uint64_t>(sequence_++);
    message_.number<std::uint64_t>(0);  // time_base, which evt3 does not use
    message_.text(kEncoding);
    message_.number<std::uint8_t>(0);  // is_bigendian
    message_.octets(encoder_.bytes());
    encoder_.clear();
    file_.add(0, end_ns, message_.bytes(), events);
    told_ns_ = end_ns;
  }

  McapFile file_;
  MessageSplitter splitter_{[this](const Events& events) { writeMessage(events); }};
  const std::uint32_t width_, height_;
  Evt3Encoder encoder_;
  CdrMessage message_;
  std::uint64_t sequence_ = 0;  // of the next message
  std::int64_t told_ns_ = 0;    // end of the last message
  std::vector<Truth> truth_;
  std::size_t channels_ = 0;  // of truth
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
