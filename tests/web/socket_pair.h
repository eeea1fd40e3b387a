// Two ends of a connection; one of them as the HTTP server hands it over.
#pragma once

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include "ops/http_upgrade.h"

namespace saccade {

class SocketPair {
 public:
  SocketPair() {
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends_) != 0) std::abort();
  }
  ~SocketPair() {
    for (const int end : ends_) close(end);
  }
  SocketPair(const SocketPair&) = delete;
  SocketPair& operator=(const SocketPair&) = delete;

  UpgradedSocket server() const {
    return {ends_[0], {nullptr, [](MHD_UpgradeResponseHandle*) {}}};
  }
  int client() const { return ends_[1]; }
  void send(std::string_view bytes) const { ::send(client(), bytes.data(), bytes.size(), MSG_NOSIGNAL); }
  std::string received() const {
    std::string all;
    char buffer[4096];
    for (ssize_t n; (n = recv(client(), buffer, sizeof buffer, 0)) > 0;)
      all.append(buffer, static_cast<std::size_t>(n));
    return all;
  }

 private:
  int ends_[2];
};

// A frame of a client: FIN and opcode, length, mask of zeros, text of less than 126 bytes.
inline std::string clientFrame(char first, const std::string& text) {
  return std::string{first, static_cast<char>(0x80 | text.size()), 0, 0, 0, 0} + text;
}

}  // namespace saccade
