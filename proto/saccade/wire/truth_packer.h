// Puts the samples of one truth channel into packets and numbers them.
//
// A picture has a packet of its own. Rows share one that ends with the first interval to reach a multiple of
// kPacketTimeNs. The intervals [t0_ns, t1_ns] of all packets cover stream time without gaps.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "saccade/wire/packet.h"
#include "saccade/wire/packet_source.h"
#include "saccade/wire/truth_samples.h"

namespace saccade {

class TruthPacker {
 public:
  struct Format {
    v1::Layout layout = v1::LAYOUT_PICTURE;
    v1::Element element = v1::ELEMENT_F32;
    std::uint32_t planes = 1;
  };
  // The first packet begins at t0_ns.
  TruthPacker(const PacketSource& source, const Format& format, std::int64_t t0_ns);

  // Adds the samples up to t1_ns, which come after those before; `frame` is the frame at t1_ns. Returns the
  // packets that are full.
  std::vector<Packet> add(TruthSamples samples, std::int64_t t1_ns, std::uint64_t frame);
  // Returns the packets up to the last t1_ns.
  std::vector<Packet> flush();
  // flush() and the last packet of this channel, at the end of the stream.
  std::vector<Packet> end(v1::EndReason reason);

  std::uint64_t samples() const { return header_.first_event_index() + rows_.size(); }

 private:
  Packet pack(std::span<const TruthSample> samples, std::int64_t t1_ns);
  v1::PacketHeader nextHeader(v1::Kind kind, std::int64_t t1_ns);

  const CodecInfo& codec_;
  v1::PacketHeader header_;  // the fields that all packets share, and the counters of the next one
  TruthSamples rows_;        // that wait for their packet
  std::int64_t t0_ns_, t1_ns_;
};

}  // namespace saccade
