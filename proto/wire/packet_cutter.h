// Cuts the events of one sensor into packets and numbers them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "wire/packet.h"

namespace saccade {

// One interval of stream time [t0_ns, t1_ns), t0_ns < t1_ns, multiples of kTimeUnitNs.
struct PacketInterval {
  std::int64_t t0_ns = 0, t1_ns = 0;
  std::uint64_t frame = 0;       // index of the frame at t0_ns
  std::uint64_t suppressed = 0;  // events the sensor withheld; told in the first packet of the interval
};

class PacketCutter {
 public:
  struct Source {
    std::string stream_id;
    std::uint64_t epoch = 0;
    std::uint32_t sensor = 0;             // index in the stream
    std::uint32_t width = 0, height = 0;  // pixels
  };
  explicit PacketCutter(const Source& source);

  // Packets of at most kMaxPacketEvents that tile the interval without holes; one empty packet where there
  // are no events. `events` are in time order and lie in the interval, which must follow the one before it. A
  // cut falls between two times; only where more events than the maximum share one time do packets with t0 =
  // t1 carry them.
  std::vector<Packet> cut(std::span<const Event> events, const PacketInterval& interval);

  // The last packet of this sensor, at the end of the stream.
  Packet end(std::int64_t t_ns, std::uint64_t frame);

 private:
  v1::PacketHeader nextHeader(v1::Kind kind, std::int64_t t0_ns, std::int64_t t1_ns, std::size_t count);

  v1::PacketHeader header_;  // what all packets of this sensor share, and the counters of the next one
};

}  // namespace saccade
