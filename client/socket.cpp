#include "client/socket.h"

#include <cerrno>
#include <stdexcept>

namespace saccade {

zmq::socket_t connectSocket(zmq::context_t& context, zmq::socket_type type, const std::string& endpoint) {
  zmq::socket_t socket(context, type);
  socket.set(zmq::sockopt::linger, 0);
  // Credit bounds what waits on a DEALER; a second bound would hold up the server's sends.
  if (type == zmq::socket_type::dealer) socket.set(zmq::sockopt::rcvhwm, 0);
  socket.set(zmq::sockopt::heartbeat_ivl, 2000);
  socket.set(zmq::sockopt::heartbeat_timeout, 6000);
  try {
    socket.connect(endpoint);
  } catch (const zmq::error_t&) {
    throw std::invalid_argument("'" + endpoint + "' is not an endpoint such as tcp://127.0.0.1:5770");
  }
  return socket;
}

bool waitReadable(zmq::socket_t& socket, std::chrono::milliseconds timeout) {
  zmq::pollitem_t item{socket.handle(), 0, ZMQ_POLLIN, 0};
  try {
    return zmq::poll(&item, 1, timeout) > 0;
  } catch (const zmq::error_t& error) {
    if (error.num() == EINTR) return false;
    throw;
  }
}

std::string reachableEndpoint(const std::string& announced, const std::string& control_endpoint) {
  constexpr std::string_view kScheme = "tcp://";
  const auto host = [&](const std::string& endpoint) {
    return endpoint.substr(kScheme.size(), endpoint.rfind(':') - kScheme.size());
  };
  if (!announced.starts_with(kScheme) || !control_endpoint.starts_with(kScheme)) return announced;
  const std::string said = host(announced);
  if (said != "*" && said != "0.0.0.0" && said != "[::]") return announced;
  return std::string(kScheme) + host(control_endpoint) + announced.substr(announced.rfind(':'));
}

}  // namespace saccade
