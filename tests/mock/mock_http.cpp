#include "mock/mock_http.h"

#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>

#include "mock/loopback.h"

namespace saccade {
HttpReply httpSend(const std::string& endpoint, const std::string& request) {
  const int fd = connectLoopback(portOf(endpoint));
  if (fd < 0) return {};
  send(fd, request.data(), request.size(), MSG_NOSIGNAL);
  std::string answer;
  char buffer[4096];
  for (ssize_t n; (n = recv(fd, buffer, sizeof buffer, 0)) > 0;) answer.append(buffer, n);
  close(fd);
  const auto end = answer.find("\r\n\r\n");
  if (end == std::string::npos || !answer.starts_with("HTTP/1.1 ")) return {};
  return {std::atoi(answer.c_str() + 9), answer.substr(0, end), answer.substr(end + 4)};
}

HttpReply httpGet(const std::string& endpoint, const std::string& path) {
  return httpSend(endpoint, "GET " + path + " HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n");
}

}  // namespace saccade
