// A ROUTER socket for untrusted peers. The libzmq that deploy/libzmq builds bounds what one may send. With
// another libzmq plain_router.cpp makes the socket, without bounds: see bounded_peers.h.
#pragma once

#include <zmq.hpp>

#include "stream/socket_options.h"

namespace saccade {

inline constexpr int kMaxParts = 2;  // of one message: a peer that sends more is disconnected

// A socket that is yet to be bound. Throws std::runtime_error where libzmq is not the one this was built for.
zmq::socket_t makeRouter(zmq::context_t& context, const SocketOptions& options);

// The sockets that may connect to it.
zmq::socket_type peerType(const SocketOptions& options);

}  // namespace saccade
