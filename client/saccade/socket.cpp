#include "saccade/socket.h"

#include <cerrno>
#include <stdexcept>

#include "saccade/wire/curve_key.h"
#include "saccade/wire/ipv6.h"

namespace saccade::client {
namespace {

constexpr int kMostWaiting = 20'000;                // packets
constexpr std::int64_t kMostMessage = 129LL << 20;  // bytes; the largest picture of truth has 128 MiB

void useKeys(zmq::socket_t& socket, const CurveKeys& keys) {
  if (!isCurveKey(keys.secret) || !isCurveKey(keys.server_public)) {
    throw std::invalid_argument("a key is 40 characters, as `saccade keygen` writes it");
  }
  char public_key[41];
  if (zmq_curve_public(public_key, keys.secret.c_str()) != 0) throw zmq::error_t();
  socket.set(zmq::sockopt::curve_serverkey, keys.server_public);
  socket.set(zmq::sockopt::curve_secretkey, keys.secret);
  socket.set(zmq::sockopt::curve_publickey, public_key);
}

}  // namespace

zmq::socket_t connectSocket(zmq::context_t& context, zmq::socket_type type, const std::string& endpoint,
                            const CurveKeys& keys, const std::function<void(zmq::socket_t&)>& before) {
  zmq::socket_t socket(context, type);
  socket.set(zmq::sockopt::linger, 0);
  socket.set(zmq::sockopt::ipv6, isIpv6(endpoint));
  socket.set(zmq::sockopt::maxmsgsize, kMostMessage);
  // Credit bounds the queue of a DEALER. Heartbeats cut off a SUB with a full queue, and libzmq 4.3 may then
  // end the program (its issue 3937). So the queue of a SUB holds most of a minute.
  socket.set(zmq::sockopt::rcvhwm, type == zmq::socket_type::dealer ? 0 : kMostWaiting);
  socket.set(zmq::sockopt::heartbeat_ivl, 2000);
  socket.set(zmq::sockopt::heartbeat_timeout, 6000);
  if (!keys.secret.empty() || !keys.server_public.empty()) useKeys(socket, keys);
  if (before) before(socket);
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

}  // namespace saccade::client
