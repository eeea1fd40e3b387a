#include "stream/credit_queue.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/check.h"
#include "base/queue_bounds.h"

namespace saccade {
namespace {

constexpr std::size_t kSmallPayload = 64;  // bytes

// The size of a block in the heap: with its own word, in steps of 16.
std::uint64_t blockOf(std::uint64_t bytes) {
  return std::max<std::uint64_t>(32, (bytes + 8 + 15) / 16 * 16);
}

}  // namespace

CreditQueue::Entry::Entry(const Packet& packet)
    : bytes(packet.header.SerializeAsString()),
      seq(packet.header.seq()),
      header_size(static_cast<std::uint32_t>(bytes.size())),
      sensor(packet.header.sensor()),
      may_drop(packet.header.kind() == v1::KIND_EVENTS || packet.header.kind() == v1::KIND_TRUTH) {
  if (packet.payload->size() > kSmallPayload) {
    payload = packet.payload;
  } else {
    bytes += *packet.payload;
    bytes.shrink_to_fit();
  }
}

std::uint64_t CreditQueue::Entry::memory() const {
  constexpr std::uint64_t kSlot = sizeof(Entry) + 8;               // with its part of the deque's own blocks
  constexpr std::uint64_t kCounted = sizeof(std::string) + 2 * 8;  // with the counters of a shared_ptr
  const std::uint64_t own = kSlot + blockOf(bytes.capacity() + 1);
  return payload ? own + blockOf(kCounted) + blockOf(payload->capacity() + 1) : own;
}

WirePacket CreditQueue::Entry::wirePacket() const {
  WirePacket packet{sensor, bytes.substr(0, header_size), payload};
  if (!payload) packet.payload = std::make_shared<const std::string>(bytes.substr(header_size));
  if (dropped_before == 0) return packet;
  v1::PacketHeader header;
  SACCADE_CHECK(header.ParseFromString(packet.header));
  header.set_dropped_before(dropped_before);
  packet.header = header.SerializeAsString();
  return packet;
}

CreditQueue::CreditQueue(Overflow overflow, std::uint64_t capacity, std::uint32_t sensors)
    : overflow_(overflow),
      capacity_(capacity),
      sent_(sensors),
      unreported_drops_(sensors),
      first_held_(sensors),
      first_unsent_(sensors) {}

bool CreditQueue::hasRoom() const {
  std::lock_guard lock(mutex_);
  return overflow_ == Overflow::kDropOldest || waiting_memory_ < capacity_;
}

void CreditQueue::push(const Packet& packet) {
  SACCADE_CHECK(packet.header.sensor() < unreported_drops_.size());
  Entry entry(packet);
  std::lock_guard lock(mutex_);
  entry.dropped_before = std::exchange(unreported_drops_[entry.sensor], 0);
  wait(std::move(entry));
}

// Before a frame and not within one: else a receiver that keeps up would lose parts of a large frame.
std::uint64_t CreditQueue::makeRoom() {
  std::lock_guard lock(mutex_);
  if (overflow_ == Overflow::kHold) return 0;
  const std::uint64_t before = dropped_packets_;
  for (auto it = waiting_.begin(); waiting_memory_ > capacity_ && it != waiting_.end();) {
    if (!it->may_drop) {
      ++it;
      continue;
    }
    reportLoss(it);
    ++dropped_packets_;
    waiting_memory_ -= it->memory();
    it = waiting_.erase(it);
  }
  return dropped_packets_ - before;
}

// Counts the loss in the next packet of the sensor, so that a client that resumes gets the same count again.
void CreditQueue::reportLoss(Entries::iterator lost) {
  const std::uint64_t drops = 1 + lost->dropped_before;
  const auto next = std::find_if(lost + 1, waiting_.end(),
                                 [&](const Entry& entry) { return entry.sensor == lost->sensor; });
  (next == waiting_.end() ? unreported_drops_[lost->sensor] : next->dropped_before) += drops;
}

bool CreditQueue::sendOldest(const Send& send) {
  std::lock_guard lock(mutex_);
  if (waiting_.empty() || !send(waiting_.front().wirePacket())) return false;
  Entry entry = std::move(waiting_.front());
  waiting_.pop_front();
  waiting_memory_ -= entry.memory();
  first_unsent_[entry.sensor] = std::max(first_unsent_[entry.sensor], entry.seq + 1);
  keep(std::move(entry));
  // The newest stays, however large.
  while (sent_memory_ > kKeptBounds * capacity_ && oldestSent().front().place + 1 < next_place_)
    forgetFirst(oldestSent());
  return true;
}

void CreditQueue::wait(Entry entry) {
  waiting_memory_ += entry.memory();
  waiting_.push_back(std::move(entry));
}

void CreditQueue::keep(Entry entry) {
  sent_memory_ += entry.memory();
  entry.place = next_place_++;
  sent_[entry.sensor].push_back(std::move(entry));
}

// There is one.
CreditQueue::Entries& CreditQueue::oldestSent() {
  return *std::ranges::min_element(
      sent_, {}, [](const Entries& entries) { return entries.empty() ? UINT64_MAX : entries.front().place; });
}

// A forgotten packet cannot be asked for again.
void CreditQueue::forgetFirst(Entries& sent) {
  const Entry& first = sent.front();
  first_held_[first.sensor] = std::max(first_held_[first.sensor], first.seq + 1);
  sent_memory_ -= first.memory();
  sent.pop_front();
}

void CreditQueue::acknowledge(std::uint32_t sensor, std::uint64_t seq) {
  std::lock_guard lock(mutex_);
  Entries& sent = sent_[sensor];
  while (!sent.empty() && sent.front().seq <= seq) forgetFirst(sent);
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
  std::vector<Entry> all;
  for (Entries& sent : sent_) std::ranges::move(std::exchange(sent, {}), std::back_inserter(all));
  std::ranges::sort(all, {}, &Entry::place);
  std::ranges::move(std::exchange(waiting_, {}), std::back_inserter(all));
  waiting_memory_ = sent_memory_ = 0;
  for (Entry& entry : all) {
    if (entry.seq < from_seqs[entry.sensor]) {
      keep(std::move(entry));
    } else {
      wait(std::move(entry));
    }
  }
  return {};
}

bool CreditQueue::empty() const {
  std::lock_guard lock(mutex_);
  return waiting_.empty();
}

std::uint64_t CreditQueue::droppedPackets() const {
  std::lock_guard lock(mutex_);
  return dropped_packets_;
}

}  // namespace saccade
