#include "ops/http_listener.h"

#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string_view>

namespace saccade {
namespace {

constexpr std::string_view kScheme = "http://";

using Addresses = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

Addresses resolve(const std::string& endpoint) {
  const std::size_t colon = endpoint.rfind(':');
  if (!endpoint.starts_with(kScheme) || colon < kScheme.size())
    throw std::runtime_error(endpoint + " is no address such as http://127.0.0.1:5773");
  std::string host = endpoint.substr(kScheme.size(), colon - kScheme.size());
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  addrinfo wish{};
  wish.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
  wish.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int fault = getaddrinfo(host.c_str(), endpoint.c_str() + colon + 1, &wish, &found);
  if (fault != 0) throw std::runtime_error("cannot listen on " + endpoint + ": " + gai_strerror(fault));
  return {found, freeaddrinfo};
}

}  // namespace

int listenForHttp(const std::string& endpoint) {
  const Addresses address = resolve(endpoint);
  const int listener = socket(address->ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  const int yes = 1;
  setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  if (listener >= 0 && bind(listener, address->ai_addr, address->ai_addrlen) == 0 &&
      listen(listener, SOMAXCONN) == 0)
    return listener;
  const std::string reason = std::strerror(errno);
  if (listener >= 0) close(listener);
  throw std::runtime_error("cannot listen on " + endpoint + ": " + reason);
}

std::string withPortOf(int listener, const std::string& endpoint) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size);
  const bool v6 = address.ss_family == AF_INET6;
  const in_port_t port = v6 ? reinterpret_cast<const sockaddr_in6&>(address).sin6_port
                            : reinterpret_cast<const sockaddr_in&>(address).sin_port;
  return endpoint.substr(0, endpoint.rfind(':') + 1) + std::to_string(ntohs(port));
}

}  // namespace saccade
