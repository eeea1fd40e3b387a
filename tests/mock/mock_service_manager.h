// systemd's end of NOTIFY_SOCKET, which it sets as long as it lives.
#pragma once

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <string>

namespace saccade {

class MockServiceManager {
 public:
  MockServiceManager() {
    // An abstract name, "@..." in the environment, leaves no file.
    const std::string name = "@saccade-test-" + std::to_string(getpid());
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path + 1, name.data() + 1, name.size() - 1);
    const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
    if (bind(fd_, reinterpret_cast<const sockaddr*>(&address), length) != 0) std::abort();
    setenv("NOTIFY_SOCKET", name.c_str(), 1);
  }
  ~MockServiceManager() {
    unsetenv("NOTIFY_SOCKET");
    close(fd_);
  }
  MockServiceManager(const MockServiceManager&) = delete;
  MockServiceManager& operator=(const MockServiceManager&) = delete;

  // The next message; empty where none comes in time.
  std::string next(std::chrono::milliseconds patience = std::chrono::seconds(30)) const {
    pollfd wait{fd_, POLLIN, 0};
    if (poll(&wait, 1, static_cast<int>(patience.count())) <= 0) return {};
    char text[256];
    const ssize_t size = recv(fd_, text, sizeof text, 0);
    return size > 0 ? std::string(text, size) : std::string();
  }

 private:
  const int fd_ = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
};

}  // namespace saccade
