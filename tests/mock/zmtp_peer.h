// A TCP peer that speaks ZMTP 3 with the mechanism NULL by hand, so that it may break every rule.
#pragma once

#include <string>

#include "mock/raw_peer.h"

namespace saccade {

// Bytes on the wire [ZMTP 3.1, https://rfc.zeromq.org/spec/37/].
std::string zmtpGreeting(int major = 3);
std::string zmtpCommand(const std::string& name, const std::string& body);
std::string zmtpPart(const std::string& bytes, bool more = false);
std::string zmtpProperty(const std::string& name, const std::string& value);

class ZmtpPeer {
 public:
  // Shakes hands as a socket of `type`, naming itself `identity`: a message that comes before the server's
  // part of the handshake would be a fault.
  explicit ZmtpPeer(const std::string& endpoint, const std::string& type = "DEALER",
                    const std::string& identity = {});

  void say(const std::string& bytes) { peer_.say(bytes); }
  std::string hear(std::size_t count) { return peer_.hear(count); }
  // Whether the server has closed the connection, or does so within `limit`.
  bool closed(std::chrono::milliseconds limit) { return peer_.closed(limit); }

 private:
  RawPeer peer_;
};

}  // namespace saccade
