// Checks from the headers that the packets of a stream are complete and in order, and finds where each
// channel resumes after a reconnection. A channel is a sensor, whose items are events, or a truth channel,
// whose items are samples.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "saccade/v1/control.pb.h"
#include "saccade/v1/events.pb.h"

namespace saccade::client {

struct Losses {
  std::uint64_t gaps = 0;     // runs of missing packets
  std::uint64_t packets = 0;  // missing packets
  std::uint64_t events = 0;   // their events
  std::uint64_t samples = 0;  // their samples, of truth channels
};

// Events of a packet's interval that its sensor withheld.
struct Withheld {
  std::uint64_t suppressed = 0;       // all of them
  std::uint64_t artefacts = 0;        // of them: likely artefacts of rendering
  std::uint64_t lost_in_readout = 0;  // of them: those that the readout had no room for

  bool covers(const Withheld& part) const;  // whether no count is less than that of `part`
  Withheld& operator+=(const Withheld& other);
  Withheld& operator-=(const Withheld& part);  // covers(part)
};
Withheld withheldOf(const v1::PacketHeader& header);

class SequenceCheck {
 public:
  // Each channel starts at seq 0, at any stream time, because a shared feed may have begun earlier. With
  // `from_event` or `from_sample` it starts at any seq, at the packet with that item.
  explicit SequenceCheck(const v1::OpenStream& resolved);

  // The new part of a packet: it begins after known_items items, at t0_ns, and leaves out known_withheld.
  struct FreshRange {
    std::uint64_t known_items;
    std::int64_t t0_ns;
    Withheld known_withheld = {};
  };
  // Returns nothing if the whole packet came before, or if its kind has no seq. Counts the losses before it.
  // Throws StreamFault if it does not continue the packet before it.
  std::optional<FreshRange> add(const v1::PacketHeader& header);

  // Call it when the request has been opened again, from items() on.
  void restart();

  // The next seq and the next item that each channel expects.
  std::vector<std::uint64_t> seqs() const;
  std::vector<std::uint64_t> items() const;

  const Losses& losses() const { return losses_; }

 private:
  struct Point {
    std::uint64_t seq = 0, item = 0;
    Withheld withheld = {};  // of the newest packet
    std::optional<std::int64_t> t_ns;
    bool joined = true;  // false: the next packet may have any seq, but has `item`
    bool ended = false;
  };
  std::optional<FreshRange> join(const Point& due, const v1::PacketHeader& header) const;
  std::optional<FreshRange> follow(const Point& due, const v1::PacketHeader& header);

  std::vector<Point> due_;  // by channel
  std::uint32_t sensors_;   // the first of them
  Losses losses_;
};

}  // namespace saccade::client
