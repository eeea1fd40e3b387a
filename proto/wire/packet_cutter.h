// Cuts the events of one sensor into packets and numbers them.
//
// A packet ends at the next multiple of kPacketTime; before that where it would hold more than
// kMaxPacketEvents, and at the end of an interval once it holds kEnoughEvents. So small frames share a
// packet, long ones fill several, and nothing waits for longer than kPacketTime of stream time.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "wire/codec_table.h"
#include "wire/packet.h"

namespace saccade {

inline constexpr std::int64_t kPacketTimeNs = 5'000'000;
inline constexpr std::size_t kEnoughEvents = 4096;

// One interval of stream time [t0_ns, t1_ns), t0_ns < t1_ns, multiples of kTimeUnitNs.
struct PacketInterval {
  std::int64_t t0_ns = 0, t1_ns = 0;
  std::uint64_t frame = 0;       // index of the frame at t0_ns
  std::uint64_t suppressed = 0;  // events the sensor withheld; told in the packet that holds t0_ns
};

class PacketCutter {
 public:
  struct Source {
    std::string stream_id;
    std::uint64_t epoch = 0;
    std::uint32_t sensor = 0;             // index in the stream
    std::uint32_t width = 0, height = 0;  // pixels
    const CodecInfo* codec = &kCodecNone;
  };
  explicit PacketCutter(const Source& source);

  // The state of the pixels at `t_ns`, where the first interval will begin. `planes` is a LAYOUT_PLANES. To
  // be called first, if at all.
  Packet snapshot(std::int64_t t_ns, std::uint64_t frame, std::string planes);

  // The packets that are full by the end of the interval; all of them tile time without holes. `events` are
  // in time order and lie in the interval, which must follow the one before it. A cut falls between two
  // times; only where more events than the maximum share one time do packets with t0 = t1 carry them.
  std::vector<Packet> cut(std::span<const Event> events, const PacketInterval& interval);

  // The packet that is not full, if there is one.
  std::vector<Packet> flush();

  // flush() and the last packet of this sensor, at the end of the stream.
  std::vector<Packet> end(std::int64_t t_ns, std::uint64_t frame, v1::EndReason reason);

 private:
  void fill(std::span<const Event> events, std::int64_t t1_ns, std::uint64_t frame,
            std::vector<Packet>& full);
  Packet take(std::span<const Event> events, std::int64_t t1_ns);
  v1::PacketHeader nextHeader(v1::Kind kind, std::int64_t t0_ns, std::int64_t t1_ns, std::uint64_t frame);

  const CodecInfo& codec_;
  v1::PacketHeader header_;  // what all packets of this sensor share, and the counters of the next one
  // The packet that is being filled.
  Events events_;
  bool open_ = false;  // covers any time yet
  std::int64_t t0_ns_ = 0, t1_ns_ = 0;
  std::uint64_t frame_ = 0, suppressed_ = 0;
};

}  // namespace saccade
