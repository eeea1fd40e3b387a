// Makes the sockets of the client and waits for them.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <zmq.hpp>

namespace saccade::client {

// CURVE keys, 40 characters each; empty for a server without keys.
struct CurveKeys {
  std::string secret;         // the client's own
  std::string server_public;  // the server's
};

// Connects a socket that drops unsent messages when it closes, and sends heartbeats to detect a lost peer. It
// cuts off a peer whose message is larger than any of the protocol. Throws std::invalid_argument for a
// malformed endpoint or key. `before`: called with the socket before it connects.
zmq::socket_t connectSocket(zmq::context_t& context, zmq::socket_type type, const std::string& endpoint,
                            const CurveKeys& keys = {},
                            const std::function<void(zmq::socket_t&)>& before = {});

// Waits for a message. Returns false after `timeout` or a signal.
bool waitReadable(zmq::socket_t& socket, std::chrono::milliseconds timeout);

// The endpoint at which this client reaches one that the server announced: the host of `control_endpoint`
// replaces a wildcard host.
std::string reachableEndpoint(const std::string& announced, const std::string& control_endpoint);

}  // namespace saccade::client
