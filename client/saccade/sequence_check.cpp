#include "saccade/sequence_check.h"

#include <algorithm>
#include <string>

#include "saccade/stream_fault.h"

namespace saccade::client {
namespace {

bool takesSeq(v1::Kind kind) {
  return kind != v1::KIND_HEARTBEAT && kind != v1::KIND_ERROR;
}

}  // namespace

bool Withheld::covers(const Withheld& part) const {
  return suppressed >= part.suppressed && artefacts >= part.artefacts &&
         lost_in_readout >= part.lost_in_readout;
}

Withheld& Withheld::operator+=(const Withheld& other) {
  suppressed += other.suppressed;
  artefacts += other.artefacts;
  lost_in_readout += other.lost_in_readout;
  return *this;
}

Withheld& Withheld::operator-=(const Withheld& part) {
  suppressed -= part.suppressed;
  artefacts -= part.artefacts;
  lost_in_readout -= part.lost_in_readout;
  return *this;
}

Withheld withheldOf(const v1::PacketHeader& header) {
  return {header.suppressed(), header.artefacts(), header.lost_in_readout()};
}

SequenceCheck::SequenceCheck(const v1::OpenStream& resolved)
    : sensors_(static_cast<std::uint32_t>(resolved.sensors_size())) {
  const auto add = [&](std::uint64_t first) {
    due_.push_back({.item = first, .t_ns = {}, .joined = first == 0});
  };
  for (const v1::Sensor& sensor : resolved.sensors()) add(sensor.from_event());
  for (const v1::Truth& truth : resolved.truth()) add(truth.from_sample());
}

std::optional<SequenceCheck::FreshRange> SequenceCheck::add(const v1::PacketHeader& header) {
  if (header.sensor() >= due_.size())
    throw StreamFault("a packet is of a sensor that the stream does not have");
  Point& due = due_[header.sensor()];
  if (!takesSeq(header.kind()) || due.ended) return std::nullopt;
  const auto fresh = due.joined ? follow(due, header) : join(due, header);
  due.seq = std::max(due.seq, header.seq() + 1);
  if (!fresh) return std::nullopt;
  due.item = header.first_event_index() + header.count();
  due.t_ns = header.t1_ns();
  due.withheld = withheldOf(header);
  due.joined = true;
  due.ended = header.kind() == v1::KIND_END;
  return fresh;
}

// The last packet of a drained stream was cut short. Its events come again, with the events after them.
std::optional<SequenceCheck::FreshRange> SequenceCheck::join(const Point& due,
                                                             const v1::PacketHeader& header) const {
  const std::uint64_t begin = header.first_event_index(), end = begin + header.count();
  const bool is_end = header.kind() == v1::KIND_END;
  if (begin > due.item || (is_end && begin < due.item)) {
    throw StreamFault("the stream was to resume at event " + std::to_string(due.item) + ", not at " +
                      std::to_string(begin));
  }
  const std::int64_t t_ns = due.t_ns.value_or(header.t0_ns());
  const bool nothing_new = begin < due.item || (due.t_ns && header.t1_ns() <= t_ns);
  if (!is_end && end <= due.item && nothing_new) return std::nullopt;
  const bool again = header.t0_ns() < t_ns;
  return FreshRange{due.item - begin, std::max(t_ns, header.t0_ns()), again ? due.withheld : Withheld()};
}

std::optional<SequenceCheck::FreshRange> SequenceCheck::follow(const Point& due,
                                                               const v1::PacketHeader& header) {
  if (header.seq() < due.seq) return std::nullopt;
  const bool gap = header.seq() > due.seq;
  if (header.first_event_index() < due.item) throw StreamFault("events run backwards");
  const bool goes_on =
      header.t0_ns() == due.t_ns.value_or(header.t0_ns()) && header.first_event_index() == due.item;
  if (!gap && !goes_on) throw StreamFault("a packet does not continue the one before it");
  if (gap) {
    ++losses_.gaps;
    losses_.packets += header.seq() - due.seq;
    (header.sensor() < sensors_ ? losses_.events : losses_.samples) += header.first_event_index() - due.item;
  }
  return FreshRange{0, header.t0_ns()};
}

void SequenceCheck::restart() {
  for (Point& due : due_) due.joined = false, due.seq = 0;
}

std::vector<std::uint64_t> SequenceCheck::seqs() const {
  std::vector<std::uint64_t> seqs;
  for (const Point& due : due_) seqs.push_back(due.seq);
  return seqs;
}

std::vector<std::uint64_t> SequenceCheck::items() const {
  std::vector<std::uint64_t> items;
  for (const Point& due : due_) items.push_back(due.item);
  return items;
}

}  // namespace saccade::client
