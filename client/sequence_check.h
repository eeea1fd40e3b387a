// Whether the packets of a stream come whole and in order, told from their headers, and where each sensor
// goes on after a break.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "saccade/v1/control.pb.h"
#include "saccade/v1/events.pb.h"

namespace saccade::client {

struct Losses {
  std::uint64_t gaps = 0;     // places where packets are missing
  std::uint64_t packets = 0;  // packets that are missing
  std::uint64_t events = 0;   // events that were in them
};

class SequenceCheck {
 public:
  // Each sensor starts at seq 0, at any time: who joins a shared feed late comes into its middle. With
  // `from_event` it starts at any seq, with the packet that holds or begins at this event.
  explicit SequenceCheck(const v1::OpenStream& resolved);

  // What is new in a packet: all but its first events, and what was suppressed among them, from a time on.
  struct FreshRange {
    std::uint64_t known_events;
    std::int64_t t0_ns;
    std::uint64_t known_suppressed = 0;
  };
  // Nothing where all of the packet came before, or where it takes no seq. Counts what is missing before it.
  // Throws StreamFault where the packet does not go on where the one before it ended.
  std::optional<FreshRange> add(const v1::PacketHeader& header);

  // The same request has been opened again, at events().
  void restart();

  // By sensor: what is due.
  std::vector<std::uint64_t> seqs() const;
  std::vector<std::uint64_t> events() const;

  const Losses& losses() const { return losses_; }

 private:
  struct Point {
    std::uint64_t seq = 0, event = 0;
    std::uint64_t suppressed = 0;  // in the newest packet
    std::optional<std::int64_t> t_ns;
    bool joined = true;  // false: the stream is to begin at `event`, whatever its seq
    bool ended = false;
  };
  std::optional<FreshRange> join(const Point& due, const v1::PacketHeader& header) const;
  std::optional<FreshRange> follow(const Point& due, const v1::PacketHeader& header);

  std::vector<Point> due_;  // by sensor
  Losses losses_;
};

}  // namespace saccade::client
