// systemd's end of NOTIFY_SOCKET, which it sets as long as it lives.
#pragma once

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

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
    const timeval patience{30, 0};
    setsockopt(fd_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    if (bind(fd_, reinterpret_cast<const sockaddr*>(&address), length) != 0) std::abort();
    setenv("NOTIFY_SOCKET", name.c_str(), 1);
  }
  ~MockServiceManager() {
    unsetenv("NOTIFY_SOCKET");
    close(fd_);
  }
  MockServiceManager(const MockServiceManager&) = delete;
  MockServiceManager& operator=(const MockServiceManager&) = delete;

  std::string next() const {  // the next message; empty where none comes
    char text[256];
    const ssize_t size = recv(fd_, text, sizeof text, 0);
    return size > 0 ? std::string(text, size) : std::string();
  }

 private:
  const int fd_ = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
};

}  // namespace saccade
