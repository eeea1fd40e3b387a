// Bags of ROS 1 with dvs_msgs/EventArray: the events of one topic. Times are those of the events, which
// cameras count from 1970.
#include "client/formats/ros/bag_source.h"
#include "client/formats/ros/event_array.h"

namespace saccade::client {
namespace {

std::unique_ptr<Reader> makeOf(const std::string& path, const SensorChoice& choice) {
  return std::make_unique<RosReader>(path, std::make_unique<BagSource>(path),
                                     std::make_unique<EventArrayDecoder>(), choice);
}

std::unique_ptr<Reader> make(const std::string& path) {
  return makeOf(path, {});
}

}  // namespace

extern const ReaderInfo kBagReader{".bag", "ROS 1 bag with dvs_msgs/EventArray", make, nullptr, makeOf};

}  // namespace saccade::client
