// The views of a stream.
#pragma once

#include "saccade/v1/control.pb.h"

namespace saccade::client {

// View `number` of a resolved request, such as Sensor.view and Truth.view have it.
inline const v1::View& viewOf(const v1::OpenStream& resolved, std::uint32_t number) {
  return number == 0 ? resolved.view() : resolved.further_views(static_cast<int>(number) - 1);
}

}  // namespace saccade::client
