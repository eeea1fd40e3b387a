// Settings of a ROUTER socket that every libzmq has.
#pragma once

#include <zmq.hpp>

#include "stream/socket_options.h"

namespace saccade {

void configureRouter(zmq::socket_t& socket, const SocketOptions& options);

}  // namespace saccade
