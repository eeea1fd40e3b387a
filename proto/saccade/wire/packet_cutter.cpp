#include "saccade/wire/packet_cutter.h"

#include <algorithm>
#include <utility>

#include "saccade/wire/columns.h"

namespace saccade {
namespace {

struct Piece {
  std::size_t count;   // events of the piece, from the front
  std::int64_t t1_ns;  // where the next piece starts
};

// The longest first packet of more than kMaxPacketEvents `events` in time order, which start at or after
// t0_ns.
Piece firstPiece(std::span<const Event> events, std::int64_t t0_ns) {
  const std::int64_t cut = events[kMaxPacketEvents].t_ns;
  const auto before_cut = std::partition_point(events.begin(), events.begin() + kMaxPacketEvents,
                                               [&](const Event& e) { return e.t_ns < cut; });
  const std::size_t count = before_cut - events.begin();
  // Nothing before the cut and nowhere to go: one time fills the whole packet.
  if (count == 0 && cut == t0_ns) return {kMaxPacketEvents, t0_ns};
  return {count, cut};
}

std::int64_t nextPacketTime(std::int64_t t_ns) {
  return (t_ns / kPacketTimeNs + 1) * kPacketTimeNs;
}

}  // namespace

PacketCutter::PacketCutter(const PacketSource& source, v1::Layout layout)
    : codec_(*source.codec), header_(headerOf(source)) {
  header_.set_layout(layout);
}

Packet PacketCutter::snapshot(std::int64_t t_ns, std::uint64_t frame, std::string planes) {
  v1::PacketHeader header = nextHeader(v1::KIND_SNAPSHOT, t_ns, t_ns, frame);
  header.set_layout(v1::LAYOUT_PLANES);
  return sealPacket(std::move(header), codec_.encode(std::move(planes)));
}

std::vector<Packet> PacketCutter::cut(std::span<const Event> events, const PacketInterval& interval) {
  std::vector<Packet> full;
  if (!open_) t0_ns_ = interval.t0_ns, frame_ = interval.frame;
  suppressed_ += interval.suppressed;
  artefacts_ += interval.artefacts;
  lost_in_readout_ += interval.lost_in_readout;
  for (std::int64_t t = interval.t0_ns; t < interval.t1_ns;) {
    t = std::min(nextPacketTime(t), interval.t1_ns);
    const auto end =
        std::partition_point(events.begin(), events.end(), [&](const Event& e) { return e.t_ns < t; });
    const std::size_t count = end - events.begin();
    fill(events.first(count), t, interval.frame, full);
    events = events.subspan(count);
  }
  return full;
}

// Adds the events up to t1_ns.
void PacketCutter::fill(std::span<const Event> events, std::int64_t t1_ns, std::uint64_t frame,
                        std::vector<Packet>& full) {
  events_.insert(events_.end(), events.begin(), events.end());
  t1_ns_ = t1_ns;
  open_ = true;
  std::span<const Event> rest = events_;
  const auto takeFirst = [&](std::size_t count, std::int64_t end_ns) {
    full.push_back(take(rest.first(count), end_ns));
    rest = rest.subspan(count);
    frame_ = frame;
  };
  while (rest.size() > kMaxPacketEvents) {
    const Piece piece = firstPiece(rest, t0_ns_);
    takeFirst(piece.count, piece.t1_ns);
  }
  if (t1_ns % kPacketTimeNs == 0 || rest.size() >= kEnoughEvents) {
    takeFirst(rest.size(), t1_ns);
    open_ = false;
  }
  events_.erase(events_.begin(), events_.end() - static_cast<std::ptrdiff_t>(rest.size()));
  giveBackSlack(events_);
}

// The packet up to t1_ns, with its events.
Packet PacketCutter::take(std::span<const Event> events, std::int64_t t1_ns) {
  v1::PacketHeader header = nextHeader(v1::KIND_EVENTS, t0_ns_, t1_ns, frame_);
  header.set_count(static_cast<std::uint32_t>(events.size()));
  header.set_suppressed(std::exchange(suppressed_, 0));
  header.set_artefacts(std::exchange(artefacts_, 0));
  header.set_lost_in_readout(std::exchange(lost_in_readout_, 0));
  header_.set_first_event_index(header_.first_event_index() + events.size());
  std::string columns = encodeColumns(events, t0_ns_, header_.layout());
  t0_ns_ = t1_ns;
  return sealPacket(std::move(header), codec_.encode(std::move(columns)));
}

std::vector<Packet> PacketCutter::flush() {
  std::vector<Packet> left;
  if (std::exchange(open_, false)) left.push_back(take(events_, t1_ns_));
  events_.clear();
  return left;
}

std::vector<Packet> PacketCutter::end(std::int64_t t_ns, std::uint64_t frame, v1::EndReason reason) {
  std::vector<Packet> last = flush();
  v1::PacketHeader header = nextHeader(v1::KIND_END, t_ns, t_ns, frame);
  header.set_end_reason(reason);
  last.push_back(sealPacket(std::move(header), {}));
  return last;
}

v1::PacketHeader PacketCutter::nextHeader(v1::Kind kind, std::int64_t t0_ns, std::int64_t t1_ns,
                                          std::uint64_t frame) {
  v1::PacketHeader header = header_;
  header.set_kind(kind);
  header.set_t0_ns(t0_ns);
  header.set_t1_ns(t1_ns);
  header.set_frame(frame);
  header_.set_seq(header_.seq() + 1);
  return header;
}

}  // namespace saccade
