// A bag of ROS 1 with dvs_msgs/EventArray, 13 bytes per event. A message covers up to 5 ms, and its stamp is
// the time of its last event. Stamps begin at 1 ns, because ROS takes 0 for "no time". Times of events stay
// as they are. Samples of truth have topics of their own.
#include <algorithm>
#include <stdexcept>

#include "client/units.h"
#include "client/writers/bag_file.h"
#include "client/writers/little_endian.h"
#include "client/writers/message_splitter.h"
#include "client/writers/ros1_message.h"
#include "client/writers/ros_truth.h"
#include "client/writers/writer.h"

namespace saccade::client {
namespace {

constexpr std::int64_t kEarliestStampNs = 1;  // ros::TIME_MIN
constexpr std::size_t kEventSize = 13;        // bytes
constexpr const char* kFrameId = "camera";
const std::string kHeader =
    std::string(80, '=') + "\nMSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n";

const BagTopic kTopic{"/dvs/events", "dvs_msgs/EventArray", "5e8beee5a6c107e504c2e78903c224b8",
                      "Header header\n"
                      "uint32 height\n"
                      "uint32 width\n"
                      "Event[] events\n" +
                          kHeader +
                          "================================================================================\n"
                          "MSG: dvs_msgs/Event\n"
                          "uint16 x\n"
                          "uint16 y\n"
                          "time ts\n"
                          "bool polarity\n"};

RosTime rosTime(std::int64_t t_ns) {
  return {static_cast<std::uint32_t>(t_ns / kNsPerSecond), static_cast<std::uint32_t>(t_ns % kNsPerSecond)};
}

char* putEvent(char* at, const Event& event) {
  const RosTime time = rosTime(event.t_ns);
  at = putNumber<std::uint16_t>(at, event.x);
  at = putNumber<std::uint16_t>(at, event.y);
  at = putNumber<std::uint32_t>(at, time.sec);
  at = putNumber<std::uint32_t>(at, time.nsec);
  return putNumber<std::uint8_t>(at, event.p);
}

void checkTimes(const Events& events) {
  constexpr std::int64_t kEndNs = (std::int64_t{UINT32_MAX} + 1) * kNsPerSecond;
  if (events.front().t_ns < 0 || events.back().t_ns >= kEndNs)
    throw std::range_error("a bag holds times from 0 to 4294967295 s, and an event is at " +
                           std::to_string(events.front().t_ns / 1e9) + " s");
}

// The topic of the events, and those of the channels that have one.
std::vector<BagTopic> topicsOf(const v1::Recording& about) {
  std::vector<BagTopic> topics{kTopic};
  const std::vector<std::string> names = rosTopics(about, "/dvs");
  for (int i = 0; i < about.truth_size(); ++i) {
    const RosMessage* message = rosMessageOf(about.truth(i));
    if (!message) continue;
    topics.push_back({names[i], message->package + "/" + message->name, message->md5sum,
                      "Header header\n" + message->fields + kHeader + message->types});
  }
  return topics;
}

class BagWriter : public Writer {
 public:
  BagWriter(const std::string& path, const v1::Recording& about)
      : file_(path, topicsOf(about)), width_(about.width()), height_(about.height()) {
    for (const v1::RecordedTruth& channel : about.truth())
      truth_.push_back({channel, rosHolds(channel) ? ++topics_ : 0});
  }

  void write(const Events& events, std::int64_t until_ns) override { splitter_.add(events, until_ns); }
  void writeTruth(int channel, const TruthSamples& samples) override {
    Truth& truth = truth_.at(channel);
    for (const TruthSample& sample : samples) {
      const RosTime stamp = rosTime(std::max(sample.t_ns, kEarliestStampNs));
      Ros1Message message;
      for (const std::uint32_t number : {truth.sequence++, stamp.sec, stamp.nsec})
        message.number<std::uint32_t>(number);
      message.text(rosMessageOf(truth.channel)->frame_id);
      appendTruth(message, truth.channel, sample);
      file_.add(truth.topic, stamp, message.bytes());
    }
  }
  void finish() override {
    splitter_.flush();
    file_.finish();
  }

 private:
  struct Truth {
    v1::RecordedTruth channel;
    std::size_t topic;
    std::uint32_t sequence = 0;
  };

  void writeMessage(const Events& events) {
    checkTimes(events);
    const RosTime stamp = rosTime(std::max(events.back().t_ns, kEarliestStampNs));
    appendHead(stamp, events.size());
    message_.resize(message_.size() + events.size() * kEventSize);
    char* at = message_.data() + message_.size() - events.size() * kEventSize;
    for (const Event& event : events) at = putEvent(at, event);
    file_.add(0, stamp, message_, events.size());
  }

  void appendHead(const RosTime& stamp, std::size_t events) {
    message_.clear();
    for (const std::uint32_t number : {sequence_++, stamp.sec, stamp.nsec})
      appendBytes<std::uint32_t>(message_, number);
    appendBytes<std::uint32_t>(message_, std::string_view(kFrameId).size());
    message_ += kFrameId;
    for (const std::size_t number : {std::size_t{height_}, std::size_t{width_}, events})
      appendBytes<std::uint32_t>(message_, number);
  }

  BagFile file_;
  MessageSplitter splitter_{[this](const Events& events) { writeMessage(events); }};
  const std::uint32_t width_, height_;
  std::uint32_t sequence_ = 0;
  std::string message_;
  std::vector<Truth> truth_;
  std::size_t topics_ = 0;  // of truth
};

std::unique_ptr<Writer> make(const std::string& path, const v1::Recording& about) {
  return std::make_unique<BagWriter>(path, about);
}

}  // namespace

const WriterInfo kBagWriter{"bag", ".bag", "ROS 1 bag with dvs_msgs/EventArray", make, false, rosHolds};

}  // namespace saccade::client
