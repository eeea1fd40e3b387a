// Whether the packets of a stream came whole and in order, told from their headers.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "saccade/v1/events.pb.h"

namespace saccade {

struct Losses {
  std::uint64_t gaps = 0;     // places where packets are missing
  std::uint64_t packets = 0;  // packets that are missing
  std::uint64_t events = 0;   // events that were in them
};

class SequenceCheck {
 public:
  // Counts what is missing before this packet; each sensor starts at seq 0, at any time: who joins a shared
  // feed late comes into its middle. Returns what is wrong, or an empty text: a seq that runs backwards, or a
  // packet that follows its predecessor and does not go on where that ended.
  std::string add(const v1::PacketHeader& header);

  const Losses& losses() const { return losses_; }

 private:
  struct Next {
    std::uint64_t seq = 0, first_event_index = 0;
    std::int64_t t0_ns = 0;
  };
  std::map<std::uint32_t, Next> next_;  // by sensor
  Losses losses_;
};

}  // namespace saccade
