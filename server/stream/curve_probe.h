// A start-up check that a socket with keys refuses unknown clients.
#pragma once

#include <string>
#include <zmq.hpp>

namespace saccade {

// Connects to the socket that this process has bound to `endpoint`, with a fresh key that is on no list.
// Throws std::runtime_error unless a ZAP handler refuses the connection. `type`: of the connecting socket,
// one that suits the bound one.
void probeRefusal(zmq::socket_type type, const std::string& endpoint, const std::string& server_secret_key);

}  // namespace saccade
