// The packets of one stream between the thread that makes them and the one that sends them, bounded by the
// memory they take.
//
// When it is full, a stream either holds its producer (who asks hasRoom() before each frame; the packets of
// one frame may overshoot) or loses its oldest packets. What is lost is counted and told in dropped_before of
// the next packet of that sensor; what is not events is never lost. What has been sent stays, bounded by
// kKeptBounds times as much, until it is acknowledged, so that a client may resume on another connection: one
// that acknowledges what it gives credit for, and gives no more than one bound, loses nothing, for the
// smallest packets take less than kKeptBounds times their bytes. So a stream without credit keeps at most the
// bound and one frame, or one packet where it drops; and kKeptBounds times the bound.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "wire/packet.h"

namespace saccade {

// A packet as it goes on the wire.
struct WirePacket {
  std::uint32_t sensor;
  std::string header;
  std::shared_ptr<const std::string> payload;

  std::uint64_t bytes() const { return header.size() + payload->size(); }
};

class CreditQueue {
 public:
  enum class Overflow { kHold, kDropOldest };

  static constexpr std::uint64_t kKeptBounds = 3;

  using Send = std::function<bool(const WirePacket&)>;  // whether it could be sent

  CreditQueue(Overflow overflow, std::uint64_t capacity, std::uint32_t sensors);

  // Producer.
  bool hasRoom() const;             // always true when the oldest are dropped
  void push(const Packet& packet);  // never waits for a receiver

  // Consumer.
  // Hands the oldest packet to `send`, which must not block nor use the queue. False: there is none, or it
  // could not be sent and stays the oldest.
  bool sendOldest(const Send& send);
  void acknowledge(std::uint32_t sensor, std::uint64_t seq);  // forgets what was sent up to `seq`
  // What comes next of each sensor is what has this seq, of those that have been sent or the one after them.
  // Returns why that cannot be done, or an empty text.
  std::string resume(const std::vector<std::uint64_t>& from_seqs);

  bool empty() const;  // nothing waits to be sent
  std::uint64_t droppedPackets() const;

 private:
  struct Entry {
    explicit Entry(const Packet& packet);
    std::uint64_t memory() const;
    WirePacket wirePacket() const;

    std::string bytes;  // the serialized header without dropped_before; behind it a small payload
    std::shared_ptr<const std::string> payload;  // a large one
    std::uint64_t seq, dropped_before = 0;
    std::uint64_t place = 0;  // of what was sent: counts up
    std::uint32_t header_size, sensor;
    bool may_drop;
  };
  using Entries = std::deque<Entry>;

  void dropOldest();
  void tellLoss(Entries::iterator lost);
  void wait(Entry entry);
  void keep(Entry entry);
  void forgetFirst(Entries& sent);
  Entries& oldestSent();

  const Overflow overflow_;
  const std::uint64_t capacity_;
  mutable std::mutex mutex_;
  Entries waiting_;
  std::vector<Entries> sent_;                           // by sensor, so that acknowledging scans nothing
  std::uint64_t waiting_memory_ = 0, sent_memory_ = 0;  // bytes
  std::uint64_t next_place_ = 0;
  std::vector<std::uint64_t> untold_drops_;  // by sensor: for the next packet to be pushed
  std::uint64_t dropped_packets_ = 0;
  // By sensor. What was sent and is forgotten has a seq below the first; what was ever sent, below the
  // second.
  std::vector<std::uint64_t> first_held_, first_unsent_;
};

}  // namespace saccade
