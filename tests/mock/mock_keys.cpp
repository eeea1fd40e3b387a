#include "mock/mock_keys.h"

#include <cstring>

namespace saccade {

void MockKeys::apply(zmq::socket_t& socket) const {
  if (secret.empty()) return;
  socket.set(zmq::sockopt::curve_serverkey, server);
  socket.set(zmq::sockopt::curve_secretkey, secret);
  socket.set(zmq::sockopt::curve_publickey, public_key);
}

MockKeys makeMockKeys(const std::string& server) {
  char public_key[41], secret_key[41];
  if (zmq_curve_keypair(public_key, secret_key) != 0) throw zmq::error_t();
  return {secret_key, public_key, server};
}

int handshake(const std::string& endpoint, const MockKeys& keys, int patience_ms, zmq::socket_type type) {
  zmq::context_t context;
  zmq::socket_t socket(context, type), monitor(context, zmq::socket_type::pair);
  socket.set(zmq::sockopt::linger, 0);
  zmq_socket_monitor(socket.handle(), "inproc://monitor",
                     ZMQ_EVENT_HANDSHAKE_SUCCEEDED | ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL |
                         ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL | ZMQ_EVENT_HANDSHAKE_FAILED_AUTH);
  monitor.set(zmq::sockopt::rcvtimeo, patience_ms);
  monitor.connect("inproc://monitor");
  keys.apply(socket);
  socket.set(zmq::sockopt::reconnect_ivl, -1);  // a second handshake would be counted, too
  socket.connect(endpoint);
  zmq::message_t event;
  std::uint16_t number = 0;
  if (monitor.recv(event)) std::memcpy(&number, event.data(), sizeof number);
  zmq_socket_monitor(socket.handle(), nullptr, 0);
  return number;
}

}  // namespace saccade
