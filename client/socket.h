// What the sockets of the client have in common.
#pragma once

#include <chrono>
#include <string>
#include <zmq.hpp>

namespace saccade::client {

// Of CURVE. Empty texts: the server works without keys.
struct CurveKeys {
  std::string secret;         // the client's own
  std::string server_public;  // the server's
};

// A socket that leaves nothing behind when it closes and notices a peer that is gone. Throws
// std::invalid_argument where `endpoint` or a key is not one.
zmq::socket_t connectSocket(zmq::context_t& context, zmq::socket_type type, const std::string& endpoint,
                            const CurveKeys& keys = {});

// Whether a message waits; false when `timeout` has passed or a signal came first.
bool waitReadable(zmq::socket_t& socket, std::chrono::milliseconds timeout);

// An endpoint the server announced, as seen from here: a wildcard host becomes the host of
// `control_endpoint`.
std::string reachableEndpoint(const std::string& announced, const std::string& control_endpoint);

}  // namespace saccade::client
