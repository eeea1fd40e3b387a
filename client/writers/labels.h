// Whether a recording has labels: Event::source and Event::artefact.
#pragma once

#include "saccade/v1/recording.pb.h"

namespace saccade::client {

inline bool hasLabels(const v1::Recording& about) {
  const auto& sensors = about.request().sensors();
  const auto sensor = static_cast<int>(about.sensor());
  return sensor >= 0 && sensor < sensors.size() && sensors[sensor].labels();
}

}  // namespace saccade::client
