// One event of an event camera. Shared by server and client.
#pragma once

#include <cstdint>
#include <vector>

namespace saccade {

struct Event {
  std::int64_t t_ns;   // stream time, a multiple of 1000
  std::uint16_t x, y;  // pixel, (0, 0) is top left
  std::uint8_t p;      // polarity: 1 ON (brighter), 0 OFF

  friend bool operator==(const Event&, const Event&) = default;
};

using Events = std::vector<Event>;  // in time order

}  // namespace saccade
