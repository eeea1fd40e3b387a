#include "stream/endpoint.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <string_view>

namespace saccade {
namespace {

// scheme://host:port; a host of IPv6 is in brackets.
struct Parts {
  std::string scheme, host, port;
};

Parts split(const std::string& endpoint) {
  const auto host = endpoint.find("://");
  if (host == std::string::npos) return {{}, endpoint, {}};
  const auto port = endpoint.rfind(':');
  if (port <= host) return {endpoint.substr(0, host), endpoint.substr(host + 3), {}};
  return {endpoint.substr(0, host), endpoint.substr(host + 3, port - host - 3), endpoint.substr(port)};
}

// Whether a program listens on the socket of a file.
bool answers(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) return false;
  std::memcpy(address.sun_path, path.data(), path.size());
  const int fd = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const bool yes = connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  close(fd);
  return yes;
}

}  // namespace

bool isLoopback(const std::string& endpoint) {
  const auto [scheme, host, port] = split(endpoint);
  if (scheme == "ipc" || scheme == "inproc") return true;
  if (host == "[::1]" || host == "localhost") return true;
  return host.starts_with("127.") && host.find_first_not_of("0123456789.") == std::string::npos;
}

std::string bindable(const std::string& endpoint) {
  const auto [scheme, host, port] = split(endpoint);
  return scheme == "tcp" && host == "localhost" ? scheme + "://127.0.0.1" + port : endpoint;
}

bool hasOnePlace(const std::string& endpoint) {
  return !endpoint.ends_with(":0") && !endpoint.ends_with(":*") && endpoint != "ipc://*";
}

std::string ipcFault(const std::string& endpoint) {
  constexpr std::string_view kScheme = "ipc://";
  if (!endpoint.starts_with(kScheme)) return {};
  const std::string path = endpoint.substr(kScheme.size());
  struct stat file {};
  if (lstat(path.c_str(), &file) != 0) return {};
  if (!S_ISSOCK(file.st_mode)) return path + " is a file and not a socket";
  return answers(path) ? "another server listens there" : "";
}

std::string reachableHere(const std::string& endpoint) {
  const auto [scheme, host, port] = split(endpoint);
  if (host == "0.0.0.0") return scheme + "://127.0.0.1" + port;
  if (host == "[::]") return scheme + "://[::1]" + port;
  return endpoint;
}

}  // namespace saccade
