// A ROUTER socket for untrusted peers. The libzmq that deploy/libzmq builds bounds what one may send.
#pragma once

#include <zmq.hpp>

#include "stream/socket_options.h"

namespace saccade {

inline constexpr int kMaxParts = 2;  // of one message: a peer that sends more is disconnected

// A socket that is yet to be bound. Throws std::runtime_error where libzmq has no bounds for peers.
zmq::socket_t makeRouter(zmq::context_t& context, const SocketOptions& options);

}  // namespace saccade
