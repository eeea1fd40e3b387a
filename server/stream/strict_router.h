// A ROUTER that expects harm of its peers: what one may send is bounded in the libzmq that deploy/libzmq
// builds.
#pragma once

#include <zmq.hpp>

#include "stream/socket_options.h"

namespace saccade {

inline constexpr int kMaxParts = 2;  // of one message: a peer that sends more is disconnected

// Not bound yet. Throws std::runtime_error where libzmq has no bounds for peers.
zmq::socket_t makeRouter(zmq::context_t& context, const SocketOptions& options);

}  // namespace saccade
