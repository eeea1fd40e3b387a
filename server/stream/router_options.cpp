#include "stream/router_options.h"

#include "saccade/wire/ipv6.h"

namespace saccade {
namespace {

constexpr int kReceiveQueue = 16;  // messages of a peer that wait here; more wait at the peer
// Bytes that one read of a connection takes at most: the system would let it grow to megabytes, and all other
// connections wait meanwhile.
constexpr int kReceiveBuffer = 256 << 10;

}  // namespace

void configureRouter(zmq::socket_t& socket, const SocketOptions& options) {
  socket.set(zmq::sockopt::ipv6, isIpv6(options.endpoint));
  socket.set(zmq::sockopt::linger, 1000);
  socket.set(zmq::sockopt::heartbeat_ivl, 2000);
  socket.set(zmq::sockopt::heartbeat_timeout, 6000);
  socket.set(zmq::sockopt::handshake_ivl, 5000);
  socket.set(zmq::sockopt::maxmsgsize, options.max_part_bytes);
  socket.set(zmq::sockopt::sndhwm, options.send_queue);
  socket.set(zmq::sockopt::rcvhwm, kReceiveQueue);
  socket.set(zmq::sockopt::rcvbuf, kReceiveBuffer);
  socket.set(zmq::sockopt::router_mandatory, true);
}

}  // namespace saccade
