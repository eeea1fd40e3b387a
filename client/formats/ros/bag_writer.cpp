// A bag of ROS 1 with dvs_msgs/EventArray, 13 bytes per event. A message covers up to 5 ms, and its stamp is
// the time of its last event, but at least 1 ns. Times of events stay as they are. Samples of truth and the
// numbers of cameras have topics of their own, and so have further sensors.
#include <memory>
#include <stdexcept>
#include <utility>

#include "client/formats/common/little_endian.h"
#include "client/formats/common/message_splitter.h"
#include "client/formats/common/ros_names.h"
#include "client/formats/common/shared_file.h"
#include "client/formats/common/units.h"
#include "client/formats/common/writer.h"
#include "client/formats/ros/bag_truth.h"
#include "client/formats/ros/event_array.h"

namespace saccade::client {
namespace {

const RosMessage kEventArray{
    "dvs_msgs",
    "EventArray",
    std::string(kEventArrayMd5),
    "uint32 height\n"
    "uint32 width\n"
    "Event[] events\n",
    "================================================================================\n"
    "MSG: dvs_msgs/Event\n"
    "uint16 x\n"
    "uint16 y\n"
    "time ts\n"
    "bool polarity\n",
    ""};

std::vector<BagTopic> topicsOf(const std::vector<RosSensor>& sensors) {
  std::vector<BagTopic> topics;
  for (const RosSensor& sensor : sensors) {
    topics.push_back(bagTopic(sensor.events, kEventArray));
    for (const BagTopic& topic : bagTruthTopics(sensor)) topics.push_back(topic);
  }
  return topics;
}

char* putEvent(char* at, const Event& event) {
  at = putNumber<std::uint16_t>(at, event.x);
  at = putNumber<std::uint16_t>(at, event.y);
  at = putNumber<std::uint32_t>(at, static_cast<std::uint32_t>(event.t_ns / kNsPerSecond));
  at = putNumber<std::uint32_t>(at, static_cast<std::uint32_t>(event.t_ns % kNsPerSecond));
  return putNumber<std::uint8_t>(at, event.p);
}

void checkTimes(const Events& events) {
  constexpr std::int64_t kEndNs = (std::int64_t{UINT32_MAX} + 1) * kNsPerSecond;
  if (events.front().t_ns < 0 || events.back().t_ns >= kEndNs)
    throw std::range_error("a bag holds times from 0 to 4294967295 s, and an event is at " +
                           std::to_string(events.front().t_ns / 1e9) + " s");
}

using SharedBag = SharedFile<BagFile>;

class BagWriter : public Writer {
 public:
  BagWriter(std::shared_ptr<SharedBag> shared, const RosSensor& sensor)
      : shared_(std::move(shared)),
        truth_(shared_->file(), sensor),
        topic_(sensor.first),
        width_(sensor.about.width()),
        height_(sensor.about.height()),
        frame_id_(sensor.frame_id) {}

  void write(const Events& events, std::int64_t until_ns) override { splitter_.add(events, until_ns); }
  void writeTruth(int channel, const TruthSamples& samples) override { truth_.write(channel, samples); }
  void finish() override {
    splitter_.flush();
    shared_->finish();
  }
  std::uint64_t kept(std::uint64_t) const override { return shared_->file().kept(topic_); }

 private:
  void writeMessage(const Events& events) {
    checkTimes(events);
    const RosTime stamp = rosStamp(events.back().t_ns);
    appendHead(stamp, events.size());
    message_.resize(message_.size() + events.size() * kEventArrayEventBytes);
    char* at = message_.data() + message_.size() - events.size() * kEventArrayEventBytes;
    for (const Event& event : events) at = putEvent(at, event);
    shared_->file().add(topic_, stamp, message_, events.size());
    truth_.writeCameras(kOfEvents, stamp);
  }

  void appendHead(const RosTime& stamp, std::size_t events) {
    message_.clear();
    for (const std::uint32_t number : {sequence_++, stamp.sec, stamp.nsec})
      appendBytes<std::uint32_t>(message_, number);
    appendBytes<std::uint32_t>(message_, frame_id_.size());
    message_ += frame_id_;
    for (const std::size_t number : {std::size_t{height_}, std::size_t{width_}, events})
      appendBytes<std::uint32_t>(message_, number);
  }

  const std::shared_ptr<SharedBag> shared_;
  BagTruth truth_;
  MessageSplitter splitter_{[this](const Events& events) { writeMessage(events); }};
  const std::size_t topic_;  // of the events
  const std::uint32_t width_, height_;
  const std::string frame_id_;
  std::uint32_t sequence_ = 0;
  std::string message_;
};

Writers makeJoint(const std::string& path, const std::vector<v1::Recording>& recordings) {
  const std::vector<RosSensor> sensors = rosSensors(recordings, kRos1Space);
  const auto shared = std::make_shared<SharedBag>(sensors.size(), path, topicsOf(sensors));
  Writers writers;
  for (const RosSensor& sensor : sensors) writers.push_back(std::make_unique<BagWriter>(shared, sensor));
  return writers;
}

std::unique_ptr<Writer> make(const std::string& path, const v1::Recording& about) {
  return std::move(makeJoint(path, {about}).front());
}

}  // namespace

extern const WriterInfo kBagWriter{
    "bag", ".bag", "ROS 1 bag with dvs_msgs/EventArray", make, false, rosHolds, false, makeJoint};

}  // namespace saccade::client
