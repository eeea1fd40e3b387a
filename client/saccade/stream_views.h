// The views of a stream, and the recordings that get the truth of each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "saccade/v1/control.pb.h"
#include "saccade/v1/recording.pb.h"

namespace saccade::client {

// How many views a request has.
inline std::uint32_t viewsOf(const v1::OpenStream& stream) {
  return static_cast<std::uint32_t>(stream.further_views_size()) + 1;
}

// View `number` of a resolved request, such as Sensor.view and Truth.view have it.
inline const v1::View& viewOf(const v1::OpenStream& resolved, std::uint32_t number) {
  return number == 0 ? resolved.view() : resolved.further_views(static_cast<int>(number) - 1);
}

// The sensor whose recording gets the truth of a view. It is the first of the view, or the first of all where
// the view has none.
int sensorOfView(const v1::OpenStream& stream, std::uint32_t view);

// The sensor whose recording gets truth channel `channel` of the stream.
int sensorOfTruth(const v1::OpenStream& stream, int channel);

// The channels that the recording of `sensor` gets, as indices in stream.truth.
std::vector<int> truthOfSensor(const v1::OpenStream& stream, int sensor);

// In the names of channels whose view is not that of the events: "_view1".
std::string viewSuffix(std::uint32_t view);

// The view of the events, and that of about.truth(channel). 0 where the request does not tell it.
std::uint32_t viewOfEvents(const v1::Recording& about);
std::uint32_t viewOfTruth(const v1::Recording& about, int channel);

// The name of about.truth(channel) without the suffix, for files that tell the view in another way.
std::string nameInView(const v1::Recording& about, int channel);

}  // namespace saccade::client
