#include "stream/credit_queue.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/check.h"

namespace saccade {

CreditQueue::CreditQueue(Overflow overflow, std::uint64_t capacity_bytes, std::uint32_t sensors)
    : overflow_(overflow),
      capacity_bytes_(capacity_bytes),
      untold_drops_(sensors),
      first_held_(sensors),
      first_unsent_(sensors) {}

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

// The newest packet stays, however large, and so does what is not events.
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
  first_unsent_[header.sensor()] = std::max(first_unsent_[header.sensor()], header.seq() + 1);
  waiting_.bytes -= entry.bytes;
  sent_.bytes += entry.bytes;
  sent_.entries.push_back(std::move(entry));
  waiting_.entries.pop_front();
  while (sent_.bytes > kKeptBounds * capacity_bytes_ && sent_.entries.size() > 1) forgetFirstSent();
  return true;
}

void CreditQueue::forgetFirstSent() {
  const Entry& first = sent_.entries.front();
  first_held_[first.packet.header.sensor()] = first.packet.header.seq() + 1;
  sent_.bytes -= first.bytes;
  sent_.entries.pop_front();
}

// What is not held any more cannot be asked for again.
void CreditQueue::acknowledge(std::uint32_t sensor, std::uint64_t seq) {
  std::lock_guard lock(mutex_);
  std::erase_if(sent_.entries, [&](const Entry& entry) {
    const v1::PacketHeader& header = entry.packet.header;
    if (header.sensor() != sensor || header.seq() > seq) return false;
    first_held_[sensor] = std::max(first_held_[sensor], header.seq() + 1);
    sent_.bytes -= entry.bytes;
    return true;
  });
}

std::string CreditQueue::resume(const std::vector<std::uint64_t>& from_seqs) {
  SACCADE_CHECK(from_seqs.size() == first_held_.size());
  std::lock_guard lock(mutex_);
  for (std::size_t i = 0; i < from_seqs.size(); ++i) {
    if (from_seqs[i] < first_held_[i]) {
      return "packets of sensor " + std::to_string(i) + " before seq " + std::to_string(first_held_[i]) +
             " are no longer held";
    }
    if (from_seqs[i] > first_unsent_[i]) {
      return "of sensor " + std::to_string(i) + " nothing has been sent from seq " +
             std::to_string(first_unsent_[i]) + " on";
    }
  }
  Entries all = std::move(sent_);
  std::move(waiting_.entries.begin(), waiting_.entries.end(), std::back_inserter(all.entries));
  sent_ = {}, waiting_ = {};
  for (Entry& entry : all.entries) {
    const v1::PacketHeader& header = entry.packet.header;
    Entries& to = header.seq() < from_seqs[header.sensor()] ? sent_ : waiting_;
    to.bytes += entry.bytes;
    to.entries.push_back(std::move(entry));
  }
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
