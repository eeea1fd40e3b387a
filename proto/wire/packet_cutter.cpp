#include "wire/packet_cutter.h"

#include <algorithm>
#include <utility>

#include "wire/codec_table.h"
#include "wire/columns.h"

namespace saccade {
namespace {

struct Piece {
  std::size_t count;   // events of the piece, from the front
  std::int64_t t1_ns;  // where the next piece starts
};

// The longest first packet of `events` (in time order), which start at or after t0_ns.
Piece firstPiece(std::span<const Event> events, std::int64_t t0_ns, std::int64_t t1_ns) {
  if (events.size() <= kMaxPacketEvents) return {events.size(), t1_ns};
  const std::int64_t cut = events[kMaxPacketEvents].t_ns;
  const auto before_cut = std::partition_point(events.begin(), events.begin() + kMaxPacketEvents,
                                               [&](const Event& e) { return e.t_ns < cut; });
  const std::size_t count = before_cut - events.begin();
  // Nothing before the cut and nowhere to go: one time fills the whole packet.
  if (count == 0 && cut == t0_ns) return {kMaxPacketEvents, t0_ns};
  return {count, cut};
}

}  // namespace

PacketCutter::PacketCutter(const Source& source) {
  header_.set_stream_id(source.stream_id);
  header_.set_epoch(source.epoch);
  header_.set_sensor(source.sensor);
  header_.set_width(source.width);
  header_.set_height(source.height);
  header_.set_dt_unit_ns(kTimeUnitNs);
  header_.set_layout(v1::LAYOUT_COLUMNS);
  header_.set_codec(kCodecNone.id);
}

std::vector<Packet> PacketCutter::cut(std::span<const Event> events, const PacketInterval& interval) {
  std::vector<Packet> packets;
  std::int64_t t0 = interval.t0_ns;
  do {
    const Piece piece = firstPiece(events, t0, interval.t1_ns);
    v1::PacketHeader header = nextHeader(v1::KIND_EVENTS, t0, piece.t1_ns, piece.count);
    header.set_frame(interval.frame);
    if (packets.empty()) header.set_suppressed(interval.suppressed);
    packets.push_back(sealPacket(
        std::move(header), kCodecNone.encode(encodeColumns(events.first(piece.count), t0, kTimeUnitNs))));
    events = events.subspan(piece.count);
    t0 = piece.t1_ns;
  } while (t0 < interval.t1_ns);
  return packets;
}

Packet PacketCutter::end(std::int64_t t_ns, std::uint64_t frame) {
  v1::PacketHeader header = nextHeader(v1::KIND_END, t_ns, t_ns, 0);
  header.set_frame(frame);
  return sealPacket(std::move(header), {});
}

v1::PacketHeader PacketCutter::nextHeader(v1::Kind kind, std::int64_t t0_ns, std::int64_t t1_ns,
                                          std::size_t count) {
  v1::PacketHeader header = header_;
  header.set_kind(kind);
  header.set_t0_ns(t0_ns);
  header.set_t1_ns(t1_ns);
  header.set_count(static_cast<std::uint32_t>(count));
  header_.set_seq(header_.seq() + 1);
  header_.set_first_event_index(header_.first_event_index() + count);
  return header;
}

}  // namespace saccade
