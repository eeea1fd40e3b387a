#include "client/formats/ros/ros_reader.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "client/formats/common/event_columns.h"

namespace saccade::client {
namespace {

constexpr std::size_t kMostNamed = 20;  // topics

// "/dvs/imu (sensor_msgs/Imu), ..."
std::string namesOf(const std::vector<RosTopic>& topics) {
  std::string names;
  for (std::size_t i = 0; i < std::min(topics.size(), kMostNamed); ++i)
    names += (i == 0 ? "" : ", ") + topics[i].name + " (" + topics[i].type + ")";
  return topics.size() > kMostNamed ? names + ", ..." : names;
}

std::vector<RosTopic> withEvents(std::vector<RosTopic> topics) {
  std::erase_if(topics, [](const RosTopic& topic) { return !topic.events; });
  return topics;
}

std::uint32_t numberOf(const std::string& path, const std::vector<RosTopic>& events,
                       const SensorChoice& choice) {
  const auto is_asked = [&](const RosTopic& topic) { return topic.name == choice.topic; };
  const auto asked = choice.topic.empty()
                         ? events.begin() + std::min<std::ptrdiff_t>(choice.sensor, std::ssize(events))
                         : std::find_if(events.begin(), events.end(), is_asked);
  if (asked == events.end() && choice.topic.empty())
    throw std::invalid_argument("--sensor: '" + path + "' has no sensor " + std::to_string(choice.sensor) +
                                "; it has 0 to " + std::to_string(events.size() - 1));
  if (asked == events.end())
    throw std::invalid_argument("--topic: '" + path + "' has no events on '" + choice.topic + "', but on " +
                                namesOf(events));
  return static_cast<std::uint32_t>(asked - events.begin());
}

}  // namespace

RosReader::RosReader(const std::string& path, std::unique_ptr<RosSource> source,
                     std::unique_ptr<EventMessageDecoder> decoder, const SensorChoice& choice)
    : path_(path), source_(std::move(source)), decoder_(std::move(decoder)) {
  const std::vector<RosTopic>& topics = source_->topics();
  const std::vector<RosTopic> events = withEvents(topics);
  if (events.empty())
    throw FileFault(path, topics.empty()
                              ? "has no topics"
                              : "has no events that can be read; its topics are " + namesOf(topics));
  sensor_ = numberOf(path, events, choice);
  topic_ =
      static_cast<std::size_t>(std::find(topics.begin(), topics.end(), events[sensor_]) - topics.begin());
  more_ = nextMessage();
}

std::string RosReader::leftOut() const {
  std::vector<RosTopic> others;
  std::uint32_t number = 0;
  for (const RosTopic& topic : source_->topics()) {
    const std::uint32_t sensor = topic.events ? number++ : 0;
    if (topic.events && sensor != sensor_)
      others.push_back({topic.name, "--sensor " + std::to_string(sensor), true});
    if (!topic.events) others.push_back(topic);
  }
  return namesOf(others);
}

bool RosReader::read(Events& events) {
  events.clear();
  return source_->placed([&] {
    while (more_ && !decoder_->append(events)) more_ = nextMessage();
    return more_;
  });
}

// Takes the next message of the topic; false: there are no more.
bool RosReader::nextMessage() {
  while (const auto message = source_->next()) {
    if (message->topic != topic_) continue;
    const ImageSize size = source_->placed([&] { return decoder_->begin(message->data); });
    if (size_.width == 0) size_ = {toSide(path_, "width", size.width), toSide(path_, "height", size.height)};
    if (size.width != size_.width || size.height != size_.height)
      throw FileFault(path_, "has messages of images of different sizes");
    return true;
  }
  return false;
}

}  // namespace saccade::client
