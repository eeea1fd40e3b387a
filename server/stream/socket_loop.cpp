#include "stream/socket_loop.h"

#include <atomic>
#include <map>
#include <stdexcept>
#include <thread>
#include <zmq.hpp>

#include "log/limited_log.h"
#include "stream/bounded_peers.h"
#include "stream/curve_probe.h"
#include "stream/descriptor_owners.h"
#include "stream/endpoint.h"
#include "stream/strict_router.h"
#include "stream/zap_handler.h"

namespace saccade {
namespace {

constexpr int kMessagesPerTurn = 64;            // then packets get their turn, too
constexpr std::size_t kBytesPerTurn = 4 << 20;  // likewise
constexpr std::chrono::milliseconds kFaultPause{100};
constexpr std::size_t kLeastShared = 1024;  // copying less costs less than sharing it

using Waiting = std::atomic<std::size_t>;  // bytes that libzmq has for one peer

// The owner of a part while libzmq has it.
struct Loan {
  MessagePart part;
  std::shared_ptr<Waiting> waiting;
};

void giveBack(void*, void* loan) {
  const std::unique_ptr<Loan> own(static_cast<Loan*>(loan));
  *own->waiting -= own->part.bytes.size();
}

zmq::message_t messageOf(const MessagePart& part, const std::shared_ptr<Waiting>& waiting) {
  if (!part.owner || part.bytes.size() < kLeastShared) {
    return zmq::message_t(part.bytes.data(), part.bytes.size());
  }
  auto loan = std::make_unique<Loan>(Loan{part, waiting});
  *waiting += part.bytes.size();
  void* bytes = const_cast<char*>(part.bytes.data());  // libzmq does not write to it
  return zmq::message_t(bytes, part.bytes.size(), giveBack, loan.release());
}

// Large messages stay where libzmq has received them: copying those of others would delay every request.
MessagePart receivedPart(zmq::message_t& message) {
  if (message.size() < kLeastShared) return std::make_shared<const std::string>(message.to_string());
  const auto owner = std::make_shared<zmq::message_t>();
  owner->copy(message);  // another reference to the same bytes
  return {owner->to_string_view(), owner};
}

}  // namespace

struct SocketLoop::Impl {
  zmq::context_t context;
  std::shared_ptr<ClientKeys> clients;
  std::optional<ZapHandler> zap;
  zmq::socket_t socket;
  std::size_t send_queue_bytes = 0;
  std::map<std::string, std::shared_ptr<Waiting>> waiting;  // by peer that was sent anything
  DescriptorOwners owners;                                  // where the ends of peers are not told
  std::atomic<bool> stop = false;
  std::atomic<std::chrono::steady_clock::time_point> last_turn = std::chrono::steady_clock::now();
  std::thread thread;

  std::optional<Message> receive();
};

SocketLoop::SocketLoop(const SocketOptions& options) : impl_(std::make_unique<Impl>()) {
  impl_->send_queue_bytes = options.send_queue_bytes;
  impl_->socket = makeRouter(impl_->context, options);
  const auto& keys = options.access.keys;
  if (keys) {
    impl_->clients = keys->clients;
    impl_->zap.emplace(impl_->context, keys->clients);
    secureServer(impl_->socket, keys->secret);
  }
  if (const std::string fault = ipcFault(options.endpoint); !fault.empty())
    throw std::runtime_error("cannot listen on " + options.endpoint + ": " + fault);
  try {
    impl_->socket.bind(bindable(options.endpoint));
    endpoint_ = impl_->socket.get(zmq::sockopt::last_endpoint);
  } catch (const zmq::error_t& fault) {
    throw std::runtime_error("cannot listen on " + options.endpoint + ": " + fault.what());
  }
  if (!keys) return;
  probeRefusal(peerType(options), endpoint_, keys->secret);
  impl_->zap->tellRefusals();  // not that of the probe
}

SocketLoop::~SocketLoop() {
  stop();
}

void SocketLoop::start(OnMessage on_message, OnTurn on_turn, OnGone on_gone) {
  impl_->thread = std::thread([this, on_message = std::move(on_message), on_turn = std::move(on_turn),
                               on_gone = std::move(on_gone)] { run(on_message, on_turn, on_gone); });
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

void SocketLoop::run(const OnMessage& on_message, const OnTurn& on_turn, const OnGone& on_gone) {
  LimitedLog log;
  auto pause = on_turn();
  while (!impl_->stop) {
    zmq::pollitem_t items[] = {{impl_->socket, 0, ZMQ_POLLIN, 0}, {nullptr, wake_.fd(), ZMQ_POLLIN, 0}};
    zmq::poll(items, 2, pause);
    if (items[1].revents) wake_.clear();
    try {
      receiveSome(on_message, on_gone);
      pause = on_turn();
    } catch (const std::exception& fault) {
      log.write(spdlog::level::err, endpoint_ + ": " + fault.what());
      pause = kFaultPause;
    }
    impl_->last_turn = std::chrono::steady_clock::now();
  }
}

void SocketLoop::receiveSome(const OnMessage& on_message, const OnGone& on_gone) {
  std::size_t bytes = 0;
  for (int i = 0; i < kMessagesPerTurn && bytes < kBytesPerTurn && !impl_->stop; ++i) {
    std::optional<Message> message = impl_->receive();
    if (!message) break;
    for (const auto& part : message->parts) bytes += part.bytes.size();
    deliver(std::move(*message), on_message, on_gone);
  }
}

void SocketLoop::deliver(Message&& message, const OnMessage& on_message, const OnGone& on_gone) {
  const auto end = [&](const std::string& peer) {
    impl_->waiting.erase(peer);
    on_gone(peer);
  };
  if (!message.former.empty()) end(message.former);
  if (message.parts.empty()) {
    end(message.peer);
  } else {
    message.revoked = !allows(message.user);
    on_message(std::move(message));
  }
}

// At the end of a connection libzmq itself delivers an empty message: a Message without parts.
std::optional<SocketLoop::Message> SocketLoop::Impl::receive() {
  zmq::message_t part;
  if (!socket.recv(part, zmq::recv_flags::dontwait)) return {};
  Message message;
  message.peer = part.to_string();
  while (part.more() && socket.recv(part, zmq::recv_flags::dontwait)) {
    if (!zmq_msg_gets(part.handle(), "Socket-Type")) break;
    // Without keys the property is what the peer says of itself.
    const char* user = clients ? zmq_msg_gets(part.handle(), "User-Id") : nullptr;
    if (user) message.user = user;
    message.parts.push_back(receivedPart(part));
  }
  if (!peersAreBounded()) message.former = owners.take(zmq_msg_get(part.handle(), ZMQ_SRCFD), message.peer);
  return message;
}

std::chrono::steady_clock::time_point SocketLoop::lastTurn() const {
  return impl_->last_turn;
}

bool SocketLoop::allows(const std::string& user) const {
  return !impl_->clients || impl_->clients->allow(user);
}

SocketLoop::Sent SocketLoop::send(const std::string& peer, std::initializer_list<MessagePart> parts) {
  auto& waiting = impl_->waiting[peer];
  if (!waiting) waiting = std::make_shared<Waiting>(0);
  if (*waiting >= impl_->send_queue_bytes) return Sent::kFull;
  try {
    // Only the first part can be refused.
    zmq::message_t name(peer.data(), peer.size());
    if (!impl_->socket.send(name, zmq::send_flags::sndmore | zmq::send_flags::dontwait)) return Sent::kFull;
    std::size_t left = parts.size();
    for (const MessagePart& part : parts) {
      const auto more = --left > 0 ? zmq::send_flags::sndmore : zmq::send_flags::none;
      zmq::message_t message = messageOf(part, waiting);
      impl_->socket.send(message, more | zmq::send_flags::dontwait);
    }
  } catch (const zmq::error_t& fault) {
    if (fault.num() != EHOSTUNREACH) throw;
    impl_->waiting.erase(peer);
    return Sent::kGone;
  }
  return Sent::kYes;
}

}  // namespace saccade
