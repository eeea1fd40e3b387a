#include "saccade/wire/truth_packer.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "saccade/wire/packet_cutter.h"

namespace saccade {

TruthPacker::TruthPacker(const PacketSource& source, const Format& format, std::int64_t t0_ns)
    : codec_(*source.codec), header_(headerOf(source)), t0_ns_(t0_ns), t1_ns_(t0_ns) {
  header_.set_layout(format.layout);
  header_.set_element(format.element);
  header_.set_planes(format.planes);
}

std::vector<Packet> TruthPacker::add(TruthSamples samples, std::int64_t t1_ns, std::uint64_t frame) {
  header_.set_frame(frame);
  std::vector<Packet> full;
  const std::int64_t before = std::exchange(t1_ns_, t1_ns);
  if (header_.layout() == v1::LAYOUT_PICTURE) {
    for (const TruthSample& sample : samples) full.push_back(pack({&sample, 1}, sample.t_ns));
    return full;
  }
  std::ranges::move(samples, std::back_inserter(rows_));
  const bool passes = before / kPacketTimeNs != t1_ns / kPacketTimeNs;
  return passes || rows_.size() >= kMaxPacketRows / 2 ? flush() : full;
}

std::vector<Packet> TruthPacker::flush() {
  std::vector<Packet> left;
  std::span<const TruthSample> rest = rows_;
  while (rest.size() > kMaxPacketRows) {
    left.push_back(pack(rest.first(kMaxPacketRows), rest[kMaxPacketRows - 1].t_ns));
    rest = rest.subspan(kMaxPacketRows);
  }
  if (t0_ns_ < t1_ns_ || !rest.empty()) left.push_back(pack(rest, t1_ns_));
  rows_.clear();
  return left;
}

std::vector<Packet> TruthPacker::end(v1::EndReason reason) {
  std::vector<Packet> last = flush();
  v1::PacketHeader header = nextHeader(v1::KIND_END, t1_ns_);
  header.set_end_reason(reason);
  last.push_back(sealPacket(std::move(header), {}));
  return last;
}

// The packet up to t1_ns, with its samples.
Packet TruthPacker::pack(std::span<const TruthSample> samples, std::int64_t t1_ns) {
  v1::PacketHeader header = nextHeader(v1::KIND_TRUTH, t1_ns);
  header.set_count(static_cast<std::uint32_t>(samples.size()));
  if (!samples.empty()) {
    header.set_exposure_begin_ns(samples.front().exposure_begin_ns);
    header.set_exposure_end_ns(samples.front().exposure_end_ns);
  }
  header_.set_first_event_index(header_.first_event_index() + samples.size());
  std::string payload = codec_.encode(encodeTruth(samples, header.layout(), header.t0_ns()));
  return sealPacket(std::move(header), std::move(payload));
}

v1::PacketHeader TruthPacker::nextHeader(v1::Kind kind, std::int64_t t1_ns) {
  v1::PacketHeader header = header_;
  header.set_kind(kind);
  header.set_t0_ns(std::exchange(t0_ns_, t1_ns));
  header.set_t1_ns(t1_ns);
  header_.set_seq(header_.seq() + 1);
  return header;
}

}  // namespace saccade
