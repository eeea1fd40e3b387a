// Cuts the events of one sensor into packets and numbers them.
//
// A packet ends at the next multiple of kPacketTimeNs. It ends earlier where it would hold more than
// kMaxPacketEvents, and at the end of an interval once it holds kEnoughEvents. So small frames share a
// packet, long ones fill several, and no event waits longer than kPacketTimeNs of stream time.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "saccade/wire/packet.h"
#include "saccade/wire/packet_source.h"

namespace saccade {

inline constexpr std::int64_t kPacketTimeNs = 5'000'000;
inline constexpr std::size_t kEnoughEvents = 4096;

// One interval of stream time [t0_ns, t1_ns), t0_ns < t1_ns, multiples of kTimeUnitNs.
struct PacketInterval {
  std::int64_t t0_ns = 0, t1_ns = 0;
  std::uint64_t frame = 0;  // index of the frame at t0_ns
  // Counted in the packet that holds t0_ns:
  std::uint64_t suppressed = 0;       // events the sensor withheld
  std::uint64_t artefacts = 0;        // those of them that are likely artefacts
  std::uint64_t lost_in_readout = 0;  // those of them that the readout had no room for
};

class PacketCutter {
 public:
  // `layout`: of events.
  explicit PacketCutter(const PacketSource& source, v1::Layout layout = v1::LAYOUT_COLUMNS);

  // The state of the pixels at `t_ns`, where the first interval will begin. `planes`: as encodePlanes() makes
  // them. Call it first or never.
  Packet snapshot(std::int64_t t_ns, std::uint64_t frame, std::string planes);

  // Returns the packets that are full by the end of the interval; all packets tile time without holes.
  // `events`: in time order, within the interval, which must follow the one before. Events of one time stay
  // in one packet; where they are more than the maximum, packets with t0 = t1 carry them.
  std::vector<Packet> cut(std::span<const Event> events, const PacketInterval& interval);

  // Returns the packet that is not full yet, if there is one.
  std::vector<Packet> flush();

  // flush() and the last packet of this sensor, at the end of the stream.
  std::vector<Packet> end(std::int64_t t_ns, std::uint64_t frame, v1::EndReason reason);

 private:
  void fill(std::span<const Event> events, std::int64_t t1_ns, std::uint64_t frame,
            std::vector<Packet>& full);
  Packet take(std::span<const Event> events, std::int64_t t1_ns);
  v1::PacketHeader nextHeader(v1::Kind kind, std::int64_t t0_ns, std::int64_t t1_ns, std::uint64_t frame);

  const CodecInfo& codec_;
  v1::PacketHeader header_;  // the fields that all packets share, and the counters of the next one
  // The packet that is being filled.
  Events events_;
  bool open_ = false;  // whether it covers any time yet
  std::int64_t t0_ns_ = 0, t1_ns_ = 0;
  std::uint64_t frame_ = 0, suppressed_ = 0, artefacts_ = 0, lost_in_readout_ = 0;
};

}  // namespace saccade
