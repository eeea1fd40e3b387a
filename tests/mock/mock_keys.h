// Keys of CURVE for tests.
#pragma once

#include <string>
#include <zmq.hpp>

namespace saccade {

struct MockKeys {
  std::string secret, public_key;
  std::string server;  // the server's public key

  void apply(zmq::socket_t& socket) const;  // nothing where they are empty
};

MockKeys makeMockKeys(const std::string& server = {});

// The outcome of a socket's first handshake: an event of zmq_socket_monitor, or 0 where there is none within
// `patience_ms`.
int handshake(const std::string& endpoint, const MockKeys& keys, int patience_ms = 10000,
              zmq::socket_type type = zmq::socket_type::dealer);

}  // namespace saccade
