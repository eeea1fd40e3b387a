// Events in time order for the tests of formats; the same for the same count.
#pragma once

#include <random>

#include "saccade/wire/event.h"

namespace saccade {

inline Events randomEvents(std::size_t count, std::uint32_t width, std::uint32_t height) {
  std::mt19937 draw(1);
  Events events;
  std::int64_t t_ns = 0;
  for (std::size_t i = 0; i < count; ++i) {
    t_ns += draw() % 8 * 1000;
    events.push_back({t_ns, static_cast<std::uint16_t>(draw() % width),
                      static_cast<std::uint16_t>(draw() % height), static_cast<std::uint8_t>(draw() % 2)});
  }
  return events;
}

}  // namespace saccade
