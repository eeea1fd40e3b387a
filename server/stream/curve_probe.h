// The proof that a door is shut.
#pragma once

#include <string>
#include <zmq.hpp>

namespace saccade {

// Connects, with a socket of a `type` that suits it, to the socket of this process that is bound to
// `endpoint`, with a key that was made for this and that nobody has allowed. Throws std::runtime_error unless
// a ZAP handler refuses it.
void probeRefusal(zmq::socket_type type, const std::string& endpoint, const std::string& server_secret_key);

}  // namespace saccade
