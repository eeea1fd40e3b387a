#include "saccade/stream_views.h"

#include <algorithm>

namespace saccade::client {

int sensorOfTruth(const v1::OpenStream& stream, int channel) {
  const auto& sensors = stream.sensors();
  const auto at = std::find_if(sensors.begin(), sensors.end(), [&](const v1::Sensor& sensor) {
    return sensor.view() == stream.truth(channel).view();
  });
  return at == sensors.end() ? 0 : static_cast<int>(at - sensors.begin());
}

std::vector<int> truthOfSensor(const v1::OpenStream& stream, int sensor) {
  std::vector<int> channels;
  for (int i = 0; i < stream.truth_size(); ++i)
    if (sensorOfTruth(stream, i) == sensor) channels.push_back(i);
  return channels;
}

std::string viewSuffix(std::uint32_t view) {
  return "_view" + std::to_string(view);
}

std::uint32_t viewOfEvents(const v1::Recording& about) {
  const v1::OpenStream& request = about.request();
  if (about.sensor() >= static_cast<std::uint32_t>(request.sensors_size())) return 0;
  const std::uint32_t view = request.sensors(static_cast<int>(about.sensor())).view();
  return view < viewsOf(request) ? view : 0;
}

std::uint32_t viewOfTruth(const v1::Recording& about, int channel) {
  if (!about.has_request()) return 0;
  const std::vector<int> channels = truthOfSensor(about.request(), static_cast<int>(about.sensor()));
  return about.request().truth(channels.at(channel)).view();
}

}  // namespace saccade::client
