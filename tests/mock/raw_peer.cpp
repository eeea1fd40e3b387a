#include "mock/raw_peer.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "mock/loopback.h"

namespace saccade {

RawPeer::RawPeer(const std::string& endpoint) : fd_(connectLoopback(portOf(endpoint))) {}

RawPeer::RawPeer(RawPeer&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

RawPeer::~RawPeer() {
  if (fd_ >= 0) close(fd_);
}

void RawPeer::say(const std::string& bytes) {
  send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
}

std::string RawPeer::hear(std::size_t bytes, std::chrono::milliseconds patience) {
  std::string heard(bytes, '\0');
  std::size_t size = 0;
  for (pollfd wait{fd_, POLLIN, 0}; size < bytes && poll(&wait, 1, static_cast<int>(patience.count())) > 0;) {
    const ssize_t got = recv(fd_, heard.data() + size, bytes - size, 0);
    if (got <= 0) break;
    size += static_cast<std::size_t>(got);
  }
  heard.resize(size);
  return heard;
}

bool RawPeer::closed(std::chrono::milliseconds limit) {
  const auto deadline = std::chrono::steady_clock::now() + limit;
  while (true) {
    const auto left = deadline - std::chrono::steady_clock::now();
    pollfd wait{fd_, POLLIN, 0};
    if (poll(&wait, 1, std::max(0, static_cast<int>(left / std::chrono::milliseconds(1)))) <= 0) return false;
    char buffer[4096];
    if (recv(fd_, buffer, sizeof buffer, 0) <= 0) return true;
  }
}

}  // namespace saccade
