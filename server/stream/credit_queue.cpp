#include "stream/credit_queue.h"

#include <algorithm>
#include <utility>

#include "base/check.h"

namespace saccade {

CreditQueue::CreditQueue(Overflow overflow, std::uint64_t capacity_bytes, std::uint32_t sensors)
    : overflow_(overflow), capacity_bytes_(capacity_bytes), untold_drops_(sensors) {}

bool CreditQueue::hasRoom() const {
  std::lock_guard lock(mutex_);
  return overflow_ == Overflow::kDropOldest || waiting_.bytes < capacity_bytes_;
}

void CreditQueue::push(Packet packet) {
  SACCADE_CHECK(packet.header.sensor() < untold_drops_.size());
  std::lock_guard lock(mutex_);
  if (auto& untold = untold_drops_[packet.header.sensor()]) {
    packet.header.set_dropped_before(std::exchange(untold, 0));
  }
  const std::uint64_t bytes = packet.header.ByteSizeLong() + packet.payload->size();
  waiting_.entries.push_back({std::move(packet), bytes});
  waiting_.bytes += bytes;
  if (overflow_ == Overflow::kDropOldest && waiting_.bytes > capacity_bytes_) dropOldest();
}

// The newest packet stays, however large, and so does what is not events: END, ERROR.
void CreditQueue::dropOldest() {
  auto& entries = waiting_.entries;
  for (auto it = entries.begin(); waiting_.bytes > capacity_bytes_ && it + 1 != entries.end();) {
    if (it->packet.header.kind() != v1::KIND_EVENTS) {
      ++it;
      continue;
    }
    tellLoss(it);
    ++dropped_packets_;
    waiting_.bytes -= it->bytes;
    it = entries.erase(it);
  }
}

// The loss goes with the packets, not with the sending: a client that resumes is told the same again.
void CreditQueue::tellLoss(std::deque<Entry>::iterator lost) {
  const v1::PacketHeader& header = lost->packet.header;
  const std::uint64_t drops = 1 + header.dropped_before();
  const auto next = std::find_if(lost + 1, waiting_.entries.end(), [&](const Entry& entry) {
    return entry.packet.header.sensor() == header.sensor();
  });
  if (next == waiting_.entries.end()) {
    untold_drops_[header.sensor()] += drops;
  } else {
    next->packet.header.set_dropped_before(next->packet.header.dropped_before() + drops);
  }
}

bool CreditQueue::sendOldest(const Send& send) {
  std::lock_guard lock(mutex_);
  if (waiting_.entries.empty()) return false;
  Entry& entry = waiting_.entries.front();
  const v1::PacketHeader& header = entry.packet.header;
  if (!send({header.sensor(), header.SerializeAsString(), entry.packet.payload})) return false;
  waiting_.bytes -= entry.bytes;
  sent_.bytes += entry.bytes;
  sent_.entries.push_back(std::move(entry));
  waiting_.entries.pop_front();
  while (sent_.bytes > capacity_bytes_ && sent_.entries.size() > 1) forgetFirstSent();
  return true;
}

void CreditQueue::forgetFirstSent() {
  const Entry& first = sent_.entries.front();
  first_resumable_ = std::max(first_resumable_, first.packet.header.seq() + 1);
  sent_.bytes -= first.bytes;
  sent_.entries.pop_front();
}

void CreditQueue::moveBackToFront(Entries& from, Entries& to) {
  from.bytes -= from.entries.back().bytes;
  to.bytes += from.entries.back().bytes;
  to.entries.push_front(std::move(from.entries.back()));
  from.entries.pop_back();
}

void CreditQueue::acknowledge(std::uint32_t sensor, std::uint64_t seq) {
  std::lock_guard lock(mutex_);
  std::erase_if(sent_.entries, [&](const Entry& entry) {
    const v1::PacketHeader& header = entry.packet.header;
    const bool safe = header.sensor() == sensor && header.seq() <= seq;
    if (safe) sent_.bytes -= entry.bytes;
    return safe;
  });
}

std::string CreditQueue::resume(std::uint64_t from_seq) {
  std::lock_guard lock(mutex_);
  if (from_seq < first_resumable_) {
    return "packets before seq " + std::to_string(first_resumable_) + " are no longer held";
  }
  // In order of sending; what is older than asked for stays behind, as sent.
  Entries older;
  while (!sent_.entries.empty()) {
    const bool again = sent_.entries.back().packet.header.seq() >= from_seq;
    moveBackToFront(sent_, again ? waiting_ : older);
  }
  sent_ = std::move(older);
  return {};
}

bool CreditQueue::empty() const {
  std::lock_guard lock(mutex_);
  return waiting_.entries.empty();
}

std::uint64_t CreditQueue::droppedPackets() const {
  std::lock_guard lock(mutex_);
  return dropped_packets_;
}

}  // namespace saccade
