// A TCP peer that speaks ZMTP 3 with the mechanism NULL by hand, so that it may break every rule.
#pragma once

#include <string>

#include "mock/raw_peer.h"
#include "mock/zmtp.h"

namespace saccade {

class ZmtpPeer {
 public:
  // Shakes hands as a socket of `type`, naming itself `identity`: a message that comes before the server's
  // part of the handshake would be a fault.
  explicit ZmtpPeer(const std::string& endpoint, const std::string& type = "DEALER",
                    const std::string& identity = {});

  void say(const std::string& bytes) { peer_.say(bytes); }
  std::string hear(std::size_t count);  // fewer bytes where the server closes, or says nothing for long
  // Whether the server has closed the connection, or does so within `limit`.
  bool closed(std::chrono::milliseconds limit) { return peer_.closed(limit); }

 private:
  RawPeer peer_;
};

}  // namespace saccade
