#include "client/formats/ros/ros_sensors.h"

#include <algorithm>
#include <map>
#include <set>

#include "client/formats/common/ros_names.h"
#include "saccade/stream_views.h"

namespace saccade::client {
namespace {

// The cameras of the recording whose view is not in `seen`, where they are added.
std::vector<RosCamera> newCameras(const v1::Recording& about, std::set<std::uint32_t>& seen) {
  std::vector<RosCamera> cameras = rosCameras(about);
  std::erase_if(cameras, [&](const RosCamera& camera) { return !seen.insert(camera.view).second; });
  return cameras;
}

std::size_t topicsOf(const RosSensor& sensor) {
  const auto& truth = sensor.about.truth();
  return 1 + static_cast<std::size_t>(std::count_if(truth.begin(), truth.end(), rosHolds)) +
         sensor.cameras.size();
}

}  // namespace

std::vector<RosSensor> rosSensors(const std::vector<v1::Recording>& sensors, const std::string& space) {
  std::vector<RosSensor> all;
  std::map<std::uint32_t, int> of_view;  // sensors so far
  std::set<std::uint32_t> cameras;
  std::size_t topics = 0;
  for (const v1::Recording& about : sensors) {
    const std::uint32_t view = viewOfEvents(about);
    const int number = of_view[view]++;
    const std::string events =
        rosSpace(space, view) + "/events" + (number == 0 ? "" : "_" + std::to_string(number));
    all.push_back({about, events, rosFrame(view), newCameras(about, cameras), topics});
    topics += topicsOf(all.back());
  }
  return all;
}

}  // namespace saccade::client
