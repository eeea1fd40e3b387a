#include "web/web_socket.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <wslay/wslay.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <utility>

namespace saccade {
namespace {

constexpr int kSendBuffer = 256 << 10;  // of the kernel: what waits there is old when it arrives
constexpr std::size_t kReadAtOnce = 64 << 10;

}  // namespace

struct WebSocket::Callbacks {
  static ssize_t fail(wslay_event_context* context) {
    const bool later = errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
    wslay_event_set_error(context, later ? WSLAY_ERR_WOULDBLOCK : WSLAY_ERR_CALLBACK_FAILURE);
    return -1;
  }
  static ssize_t receive(wslay_event_context* context, std::uint8_t* buffer, std::size_t size, int,
                         void* self) {
    auto& socket = *static_cast<WebSocket*>(self);
    size = std::min(size, socket.may_read_);
    errno = EAGAIN;
    const ssize_t got = size == 0 ? -1 : recv(socket.fd(), buffer, size, 0);
    if (got == 0) errno = ECONNRESET;
    if (got <= 0) return fail(context);
    socket.may_read_ -= static_cast<std::size_t>(got);
    socket.heard_ = Clock::now();
    return got;
  }
  static ssize_t transmit(wslay_event_context* context, const std::uint8_t* data, std::size_t size, int,
                          void* self) {
    auto& socket = *static_cast<WebSocket*>(self);
    const ssize_t sent = send(socket.fd(), data, size, MSG_NOSIGNAL);
    if (sent < 0) return fail(context);
    socket.taken_ = Clock::now();
    return sent;
  }
  static void message(wslay_event_context*, const wslay_event_on_msg_recv_arg* message, void* self) {
    auto& socket = *static_cast<WebSocket*>(self);
    if (message->opcode == WSLAY_BINARY_FRAME) {
      socket.close(WSLAY_CODE_UNSUPPORTED_DATA, "messages are text");
    } else if (message->opcode == WSLAY_TEXT_FRAME) {
      socket.on_text_({reinterpret_cast<const char*>(message->msg), message->msg_length});
    }
  }
};

WebSocket::WebSocket(UpgradedSocket socket, OnText on_text)
    : socket_(std::move(socket)),
      on_text_(std::move(on_text)),
      context_(nullptr, wslay_event_context_free),
      taken_(Clock::now()),
      heard_(taken_),
      pinged_(taken_) {
  const wslay_event_callbacks callbacks{
      Callbacks::receive, Callbacks::transmit, nullptr, nullptr, nullptr, nullptr, Callbacks::message};
  wslay_event_context* context = nullptr;
  if (wslay_event_context_server_init(&context, &callbacks, this) != 0) throw std::bad_alloc();
  context_.reset(context);
  wslay_event_config_set_max_recv_msg_length(context, kMaxText);
  const int yes = 1;
  setsockopt(fd(), IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  setsockopt(fd(), SOL_SOCKET, SO_SNDBUF, &kSendBuffer, sizeof kSendBuffer);
}

short WebSocket::events() const {
  const int in = wslay_event_want_read(context_.get()) && !full() ? POLLIN : 0;
  return static_cast<short>(in | (wslay_event_want_write(context_.get()) ? POLLOUT : 0));
}

void WebSocket::queue(std::uint8_t opcode, std::string_view bytes) {
  if (queuedBytes() == 0) taken_ = Clock::now();
  const wslay_event_msg message{opcode, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
  if (wslay_event_queue_msg(context_.get(), &message) == WSLAY_ERR_NOMEM) throw std::bad_alloc();
}

void WebSocket::sendText(std::string_view text) {
  queue(WSLAY_TEXT_FRAME, text);
}

void WebSocket::sendBinary(std::string_view bytes) {
  queue(WSLAY_BINARY_FRAME, bytes);
}

void WebSocket::close(std::uint16_t code, std::string_view reason) {
  wslay_event_queue_close(context_.get(), code, reinterpret_cast<const std::uint8_t*>(reason.data()),
                          reason.size());
  wslay_event_send(context_.get());
}

bool WebSocket::exchange() {
  may_read_ = full() ? 0 : kReadAtOnce;
  return wslay_event_recv(context_.get()) == 0 && wslay_event_send(context_.get()) == 0 && alive();
}

bool WebSocket::alive() {
  const auto now = Clock::now();
  if (now - std::max(pinged_, heard_) > kPing) {
    pinged_ = now;
    queue(WSLAY_PING, {});
  }
  const bool stalled = queuedBytes() > 0 && now - taken_ > kStall;
  return !wslay_event_get_close_sent(context_.get()) && !stalled && now - heard_ <= kSilence;
}

std::size_t WebSocket::queuedBytes() const {
  return wslay_event_get_queued_msg_length(context_.get());
}

bool WebSocket::full() const {
  return queuedBytes() > kFullQueue || wslay_event_get_queued_msg_count(context_.get()) > kFullCount;
}

}  // namespace saccade
