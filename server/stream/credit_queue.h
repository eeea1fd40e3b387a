// The queue of one stream's packets, from the thread that makes them to the one that sends them. It bounds
// the memory that they take.
//
// A full queue holds its producer, who asks hasRoom() before each frame. Or it drops its oldest packets
// of events and truth as the producer begins a frame. Then dropped_before of the channel's next packet
// tells how many. Snapshots, END and ERROR are never dropped.
//
// Sent packets stay until they are acknowledged, in kKeptBounds times the bound, so that a client may resume
// on another connection. A client loses nothing if it gives at most one bound of credit and acknowledges when
// it gives more. The smallest packets take less than kKeptBounds times their bytes.
//
// A full queue thus takes the bound and the packets of one frame, and kKeptBounds times the bound for sent
// packets.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "saccade/wire/packet.h"

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

  using Send = std::function<bool(const WirePacket&)>;  // whether it could be sent

  CreditQueue(Overflow overflow, std::uint64_t capacity, std::uint32_t sensors);

  // Producer.
  bool hasRoom() const;             // always true when the oldest are dropped
  std::uint64_t makeRoom();         // before the packets of a frame; returns how many it has dropped
  void push(const Packet& packet);  // never waits for a receiver

  // Consumer.
  // Hands the oldest packet to `send`. False: there is none, or it could not be sent and stays the oldest.
  // `send` runs under the queue's lock, so that the packet cannot be dropped meanwhile; it must not block nor
  // use the queue.
  bool sendOldest(const Send& send);
  void acknowledge(std::uint32_t sensor, std::uint64_t seq);  // forgets sent packets up to `seq`
  // Goes back: the next packet of each sensor is the one with this seq, which was sent before or is next
  // anyway. Returns an empty text, or why that cannot be done.
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
    std::uint64_t place = 0;  // of a sent packet: its place in the order of sending
    std::uint32_t header_size, sensor;
    bool may_drop;
  };
  using Entries = std::deque<Entry>;

  void reportLoss(Entries::iterator lost);
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
  std::vector<std::uint64_t> unreported_drops_;  // by sensor: for the next packet to be pushed
  std::uint64_t dropped_packets_ = 0;
  // By sensor: the seq after the last forgotten packet, and after the last sent one.
  std::vector<std::uint64_t> first_held_, first_unsent_;
};

}  // namespace saccade
