#include "stream/socket_loop.h"

#include <atomic>
#include <stdexcept>
#include <thread>
#include <zmq.hpp>

#include "stream/curve_probe.h"
#include "stream/zap_handler.h"

namespace saccade {
namespace {

constexpr std::size_t kMaxParts = 3;
constexpr int kReceiveQueue = 16;     // messages of a peer that wait here; more wait at the peer
constexpr int kMessagesPerTurn = 64;  // then packets get their turn, too

void configure(zmq::socket_t& socket, const SocketOptions& options) {
  // A socket with IPv6 states IPv4 addresses in a form that few clients understand.
  socket.set(zmq::sockopt::ipv6, options.endpoint.find('[') != std::string::npos);
  socket.set(zmq::sockopt::linger, 1000);
  socket.set(zmq::sockopt::heartbeat_ivl, 2000);
  socket.set(zmq::sockopt::heartbeat_timeout, 6000);
  socket.set(zmq::sockopt::handshake_ivl, 5000);
  socket.set(zmq::sockopt::maxmsgsize, options.max_part_bytes);
  socket.set(zmq::sockopt::sndhwm, options.send_queue);
  socket.set(zmq::sockopt::rcvhwm, kReceiveQueue);
  if (options.kind == SocketOptions::Kind::kRouter) {
    socket.set(zmq::sockopt::router_mandatory, true);
  } else {
    socket.set(zmq::sockopt::xpub_verbose, true);  // every subscription is seen, not only a topic's first
    socket.set(zmq::sockopt::xpub_manual, true);   // and takes effect only where we say so
  }
}

SocketLoop::Message receive(zmq::socket_t& socket) {
  SocketLoop::Message message;
  zmq::message_t part;
  do {
    if (!socket.recv(part, zmq::recv_flags::dontwait)) break;
    const char* user = zmq_msg_gets(part.handle(), "User-Id");
    if (user) message.user = user;
    if (message.parts.size() < kMaxParts) message.parts.push_back(part.to_string());
  } while (part.more());
  return message;
}

}  // namespace

// What ZeroMQ makes up begins with 0, and a peer cannot guess that of another [zmq_setsockopt,
// ZMQ_ROUTING_ID].
bool hasServersName(const std::string& identity) {
  return identity.starts_with('\0');
}

struct SocketLoop::Impl {
  zmq::context_t context;
  std::shared_ptr<const ClientKeys> clients;
  std::optional<ZapHandler> zap;
  zmq::socket_t socket;
  std::atomic<bool> stop = false;
  std::atomic<std::chrono::steady_clock::time_point> last_turn = std::chrono::steady_clock::now();
  std::thread thread;
};

SocketLoop::SocketLoop(const SocketOptions& options) : impl_(std::make_unique<Impl>()) {
  const bool router = options.kind == SocketOptions::Kind::kRouter;
  impl_->socket = {impl_->context, router ? zmq::socket_type::router : zmq::socket_type::xpub};
  configure(impl_->socket, options);
  if (options.keys) {
    impl_->clients = options.keys->clients;
    impl_->zap.emplace(impl_->context, options.keys->clients);
    secureServer(impl_->socket, options.keys->secret);
  }
  try {
    impl_->socket.bind(options.endpoint);
    endpoint_ = impl_->socket.get(zmq::sockopt::last_endpoint);
  } catch (const zmq::error_t& fault) {
    throw std::runtime_error("cannot listen on " + options.endpoint + ": " + fault.what());
  }
  if (!options.keys) return;
  probeRefusal(router ? zmq::socket_type::dealer : zmq::socket_type::sub, endpoint_, options.keys->secret);
}

SocketLoop::~SocketLoop() {
  stop();
}

void SocketLoop::start(OnMessage on_message, OnTurn on_turn) {
  impl_->thread = std::thread(
      [this, on_message = std::move(on_message), on_turn = std::move(on_turn)] { run(on_message, on_turn); });
}

void SocketLoop::stop() {
  if (!impl_->thread.joinable()) return;
  impl_->stop = true;
  wake_.wake();
  impl_->thread.join();
  impl_->socket.close();
  impl_->zap.reset();
  impl_->context.close();
}

void SocketLoop::run(const OnMessage& on_message, const OnTurn& on_turn) {
  auto pause = on_turn();
  while (!impl_->stop) {
    zmq::pollitem_t items[] = {{impl_->socket, 0, ZMQ_POLLIN, 0}, {nullptr, wake_.fd(), ZMQ_POLLIN, 0}};
    zmq::poll(items, 2, pause);
    if (items[1].revents) wake_.clear();
    for (int i = 0; i < kMessagesPerTurn; ++i) {
      const Message message = receive(impl_->socket);
      if (message.parts.empty()) break;
      if (allows(message.user)) on_message(message);
    }
    pause = on_turn();
    impl_->last_turn = std::chrono::steady_clock::now();
  }
}

std::chrono::steady_clock::time_point SocketLoop::lastTurn() const {
  return impl_->last_turn;
}

bool SocketLoop::allows(const std::string& user) const {
  return !impl_->clients || impl_->clients->allow(user);
}

SocketLoop::Sent SocketLoop::send(std::initializer_list<std::string_view> parts) {
  std::size_t left = parts.size();
  for (std::string_view part : parts) {
    const auto more = --left > 0 ? zmq::send_flags::sndmore : zmq::send_flags::none;
    try {
      // Only the first part can be refused.
      if (!impl_->socket.send(zmq::buffer(part), more | zmq::send_flags::dontwait)) return Sent::kFull;
    } catch (const zmq::error_t& fault) {
      if (fault.num() == EHOSTUNREACH) return Sent::kGone;
      throw;
    }
  }
  return Sent::kYes;
}

void SocketLoop::setSubscription(const std::string& topic, bool wanted) {
  if (wanted) {
    impl_->socket.set(zmq::sockopt::subscribe, topic);
  } else {
    impl_->socket.set(zmq::sockopt::unsubscribe, topic);
  }
}

}  // namespace saccade
