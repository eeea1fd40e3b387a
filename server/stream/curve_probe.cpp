#include "stream/curve_probe.h"

#include <cstring>
#include <stdexcept>

#include "saccade/wire/ipv6.h"
#include "stream/endpoint.h"
#include "stream/public_key.h"

namespace saccade {
namespace {

constexpr int kTimeoutMs = 5000;

void connectStranger(zmq::socket_t& socket, const std::string& endpoint, const std::string& server_secret) {
  char public_key[41], secret_key[41];
  if (zmq_curve_keypair(public_key, secret_key) != 0) throw zmq::error_t();
  socket.set(zmq::sockopt::linger, 0);
  socket.set(zmq::sockopt::reconnect_ivl, -1);  // only one handshake is the probe's
  socket.set(zmq::sockopt::ipv6, isIpv6(endpoint));
  socket.set(zmq::sockopt::curve_serverkey, publicKeyOf(server_secret));
  socket.set(zmq::sockopt::curve_publickey, public_key);
  socket.set(zmq::sockopt::curve_secretkey, secret_key);
  socket.connect(endpoint);
}

// How the first handshake ended: an event of zmq_socket_monitor and its value; zeros where none came in time.
struct Outcome {
  std::uint16_t event = 0;
  std::uint32_t value = 0;
};

Outcome awaitHandshake(zmq::socket_t& monitor) {
  monitor.set(zmq::sockopt::rcvtimeo, kTimeoutMs);
  zmq::message_t event, address;
  Outcome outcome;
  if (!monitor.recv(event) || !monitor.recv(address)) return {};
  std::memcpy(&outcome.event, event.data(), sizeof outcome.event);
  std::memcpy(&outcome.value, event.data<char>() + sizeof outcome.event, sizeof outcome.value);
  return outcome;
}

}  // namespace

void probeRefusal(zmq::socket_type type, const std::string& endpoint, const std::string& server_secret_key) {
  zmq::context_t context;
  zmq::socket_t stranger(context, type), monitor(context, zmq::socket_type::pair);
  constexpr int kHandshakes = ZMQ_EVENT_HANDSHAKE_SUCCEEDED | ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL |
                              ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL | ZMQ_EVENT_HANDSHAKE_FAILED_AUTH;
  if (zmq_socket_monitor(stranger.handle(), "inproc://probe", kHandshakes) != 0) throw zmq::error_t();
  monitor.connect("inproc://probe");
  connectStranger(stranger, reachableHere(endpoint), server_secret_key);
  const Outcome outcome = awaitHandshake(monitor);
  zmq_socket_monitor(stranger.handle(), nullptr, 0);
  if (outcome.event == ZMQ_EVENT_HANDSHAKE_FAILED_AUTH && outcome.value == 400) return;
  throw std::runtime_error("an unknown key is not refused at " + endpoint + " (event " +
                           std::to_string(outcome.event) + ", " + std::to_string(outcome.value) +
                           "): not serving");
}

}  // namespace saccade
