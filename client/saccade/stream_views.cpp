#include "saccade/stream_views.h"

#include <algorithm>

namespace saccade::client {

int sensorOfView(const v1::OpenStream& stream, std::uint32_t view) {
  const auto& sensors = stream.sensors();
  const auto at = std::find_if(sensors.begin(), sensors.end(),
                               [=](const v1::Sensor& sensor) { return sensor.view() == view; });
  return at == sensors.end() ? 0 : static_cast<int>(at - sensors.begin());
}

int sensorOfTruth(const v1::OpenStream& stream, int channel) {
  return sensorOfView(stream, stream.truth(channel).view());
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

std::string nameInView(const v1::Recording& about, int channel) {
  const std::uint32_t view = viewOfTruth(about, channel);
  std::string name = about.truth(channel).name();
  if (view == viewOfEvents(about)) return name;
  const std::string suffix = viewSuffix(view);
  return name.erase(name.find(suffix), suffix.size());
}

}  // namespace saccade::client
