#include "ops/http_connection.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace saccade {
namespace {

constexpr std::size_t kMaxHeadBytes = 8192;

bool mayComeLater() {
  return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
}

}  // namespace

HttpConnection::~HttpConnection() {
  close(socket_);
}

short HttpConnection::awaits() const {
  return state_ == State::kWriting ? POLLOUT : POLLIN;
}

bool HttpConnection::goOn(const HttpPages& pages) {
  if (Clock::now() >= until_) return false;
  if (state_ == State::kReading && !read(pages)) return false;
  if (state_ == State::kWriting && !write()) return false;
  return state_ != State::kLeaving || leave();
}

bool HttpConnection::read(const HttpPages& pages) {
  std::array<char, kMaxHeadBytes> bytes;
  const ssize_t got = recv(socket_, bytes.data(), bytes.size() - head_.size(), 0);
  if (got <= 0) return got < 0 && mayComeLater();
  head_.append(bytes.data(), static_cast<std::size_t>(got));
  if (head_.find(kHttpHeadEnd) != head_.npos) {
    response_ = httpResponse(head_, pages);
  } else if (head_.size() == kMaxHeadBytes) {
    response_ = httpTooLong();
  } else {
    return true;
  }
  state_ = State::kWriting;
  return true;
}

bool HttpConnection::write() {
  const ssize_t sent = send(socket_, response_.data() + written_, response_.size() - written_, MSG_NOSIGNAL);
  if (sent < 0) return mayComeLater();
  written_ += static_cast<std::size_t>(sent);
  if (written_ < response_.size()) return true;
  shutdown(socket_, SHUT_WR);
  state_ = State::kLeaving;
  return true;
}

// To close while bytes of a body are still unread would reset the connection, and take the answer away.
bool HttpConnection::leave() const {
  std::array<char, kMaxHeadBytes> unread;
  const ssize_t got = recv(socket_, unread.data(), unread.size(), 0);
  return got > 0 || (got < 0 && mayComeLater());
}

}  // namespace saccade
