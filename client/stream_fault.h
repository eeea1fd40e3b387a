// Why a client cannot go on with a stream.
#pragma once

#include <stdexcept>
#include <string>

namespace saccade::client {

// The stream cannot go on, or what arrives cannot be trusted.
struct StreamFault : std::runtime_error {
  using runtime_error::runtime_error;
};

// The server says so, with a packet of KIND_ERROR.
struct StreamRefused : StreamFault {
  StreamRefused(const std::string& message, bool names_stream)
      : StreamFault(message), connection_only(!names_stream) {}
  bool connection_only;  // credit or an acknowledgement came from a connection that has not attached
};

}  // namespace saccade::client
