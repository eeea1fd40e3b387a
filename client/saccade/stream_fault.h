// The exceptions of a stream that cannot go on.
#pragma once

#include <stdexcept>
#include <string>

#include "saccade/v1/events.pb.h"

namespace saccade::client {

// The stream cannot go on, or a packet fails its checks.
struct StreamFault : std::runtime_error {
  using runtime_error::runtime_error;
};

// The server sent a packet of KIND_ERROR.
struct StreamRefused : StreamFault {
  StreamRefused(const std::string& message, bool names_stream)
      : StreamFault(message), connection_only(!names_stream) {}
  bool connection_only;  // true: this connection has not attached; the stream itself may be sound
};

// How the server ended a stream early, from the header of its END packet, for people.
inline std::string endText(const v1::PacketHeader& end) {
  const std::string at = " at frame " + std::to_string(end.frame());
  if (end.end_reason() == v1::END_REASON_DRAINING) return "the server has stopped and ended the stream" + at;
  if (end.end_reason() == v1::END_REASON_ABANDONED)
    return "the server ended the stream, which nobody received," + at;
  return "the server ended the stream" + at;
}

}  // namespace saccade::client
