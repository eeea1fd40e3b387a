#include "client/sequence_check.h"

namespace saccade {

std::string SequenceCheck::add(const v1::PacketHeader& header) {
  if (header.kind() == v1::KIND_HEARTBEAT || header.kind() == v1::KIND_ERROR) return {};  // they take no seq
  Next& next = next_.try_emplace(header.sensor(), Next{0, 0, header.t0_ns()}).first->second;
  if (header.seq() < next.seq || header.first_event_index() < next.first_event_index) {
    return "it is out of order";
  }
  if (header.seq() > next.seq) {
    ++losses_.gaps;
    losses_.packets += header.seq() - next.seq;
    losses_.events += header.first_event_index() - next.first_event_index;
  } else if (header.t0_ns() != next.t0_ns || header.first_event_index() != next.first_event_index) {
    return "it does not go on where the one before it ended";
  }
  next = {header.seq() + 1, header.first_event_index() + header.count(), header.t1_ns()};
  return {};
}

}  // namespace saccade
