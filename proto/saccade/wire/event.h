// One event of an event camera. Shared by server and client.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace saccade {

inline constexpr std::uint32_t kTimeUnitNs = 1000;  // of all event times and packet bounds

struct Event {
  std::int64_t t_ns;   // stream time
  std::uint16_t x, y;  // pixel, (0, 0) is top left
  std::uint8_t p;      // polarity: 1 ON (brighter), 0 OFF
  // Labels; 0 where they are not asked for.
  std::uint8_t source = 0;    // v1::EventSource
  std::uint8_t artefact = 0;  // 255 times the odds that the event is an error of rendering
  std::uint32_t object = 0;   // number in the truth channel ids; 0: nothing, or not asked for

  friend bool operator==(const Event&, const Event&) = default;
};

using Events = std::vector<Event>;  // in time order

// Frees memory of a large buffer that is mostly empty.
inline void giveBackSlack(Events& buffer) {
  constexpr std::size_t kSmall = 1 << 16, kMuch = 8;
  if (buffer.capacity() > kSmall && buffer.capacity() / kMuch > buffer.size()) buffer.shrink_to_fit();
}

}  // namespace saccade
