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
  // Together 4 bytes, so that an event has 16.
  std::uint8_t p : 1;  // polarity: 1 ON (brighter), 0 OFF
  // 0 where they are not asked for:
  std::uint8_t source : 3 = 0;    // v1::EventSource
  std::uint32_t object : 20 = 0;  // number in the truth channel ids; 0: nothing
  std::uint8_t artefact = 0;      // 255 times the odds that the event is an error of rendering

  friend bool operator==(const Event&, const Event&) = default;
};

inline constexpr std::uint32_t kMaxSource = (1 << 3) - 1, kMaxObject = (1 << 20) - 1;
static_assert(sizeof(Event) == 16);

using Events = std::vector<Event>;  // in time order

// Frees memory of a large buffer that is mostly empty.
inline void giveBackSlack(Events& buffer) {
  constexpr std::size_t kSmall = 1 << 16, kMuch = 8;
  if (buffer.capacity() > kSmall && buffer.capacity() / kMuch > buffer.size()) buffer.shrink_to_fit();
}

}  // namespace saccade
