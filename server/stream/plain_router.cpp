// The sockets of a build with a libzmq that deploy/libzmq/strict_peers.patch has not changed.
#include "stream/bounded_peers.h"
#include "stream/refused_connections.h"
#include "stream/router_options.h"
#include "stream/strict_router.h"

namespace saccade {

bool peersAreBounded() {
  return false;
}

zmq::socket_t makeRouter(zmq::context_t& context, const SocketOptions& options) {
  zmq::socket_t socket(context, zmq::socket_type::router);
  configureRouter(socket, options);
  return socket;
}

zmq::socket_type peerType(const SocketOptions&) {
  return zmq::socket_type::dealer;
}

int refusedConnections() {
  return 0;
}

}  // namespace saccade
