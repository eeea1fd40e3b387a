// Counts packets sent and dropped, on all streams together since the server started.
#pragma once

#include <atomic>
#include <cstdint>

namespace saccade {

struct Traffic {
  std::atomic<std::uint64_t> packets = 0, bytes = 0;  // sent; a packet that is sent again counts again
  std::atomic<std::uint64_t> dropped_packets = 0;     // of LIVE streams without credit
};

}  // namespace saccade
