#include "stream/strict_router.h"

#include <stdexcept>

#include "stream/bounded_peers.h"
#include "stream/refused_connections.h"
#include "stream/router_options.h"

namespace saccade {
namespace {

constexpr int kRouterNotify = 97, kNotifyDisconnect = 2;  // ZMQ_..., which zmq.h hides as drafts
constexpr const char* kCapability = "strict-peers";

void setOption(zmq::socket_t& socket, int option, int value) {
  if (zmq_setsockopt(socket.handle(), option, &value, sizeof value) != 0) throw zmq::error_t();
}

void bound(zmq::socket_t& socket, const SocketOptions& options) {
  setOption(socket, kRouterNotify, kNotifyDisconnect);
  setOption(socket, ZMQ_MAX_PARTS, kMaxParts);
  setOption(socket, ZMQ_MAX_PEERS, options.access.connections);
  setOption(socket, ZMQ_MAX_PEERS_OF_CLIENT, options.access.client_connections);
  setOption(socket, ZMQ_SERVE_AS_XPUB, options.for_subscribers);
}

}  // namespace

bool peersAreBounded() {
  return true;  // or makeRouter() throws
}

zmq::socket_t makeRouter(zmq::context_t& context, const SocketOptions& options) {
  if (!zmq_has(kCapability)) {
    throw std::runtime_error(
        "this libzmq has no bounds for what peers send: use the one that deploy/libzmq/build makes");
  }
  zmq_ctx_set(context.handle(), ZMQ_MAX_INBOUND_MIB, options.access.inbound_mib);
  zmq::socket_t socket(context, zmq::socket_type::router);
  configureRouter(socket, options);
  bound(socket, options);
  return socket;
}

zmq::socket_type peerType(const SocketOptions& options) {
  return options.for_subscribers ? zmq::socket_type::sub : zmq::socket_type::dealer;
}

int refusedConnections() {
  zmq::context_t any;  // the count is of the process
  return zmq_ctx_get(any.handle(), ZMQ_REFUSED_PEERS);
}

}  // namespace saccade
