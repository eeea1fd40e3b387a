#include "client/dv/listener.h"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <system_error>

namespace saccade::client::dv {
namespace {

constexpr int kWaiting = 16;  // connections that have not been accepted

struct SocketAddress {
  sockaddr_storage storage{};
  socklen_t size = sizeof(storage);
  sockaddr* get() { return reinterpret_cast<sockaddr*>(&storage); }
};

std::string nameOf(SocketAddress address) {
  char host[NI_MAXHOST], port[NI_MAXSERV];
  if (getnameinfo(address.get(), address.size, host, sizeof host, port, sizeof port,
                  NI_NUMERICHOST | NI_NUMERICSERV) != 0)
    return "?";
  const bool v6 = address.storage.ss_family == AF_INET6;
  return (v6 ? "[" + std::string(host) + "]" : std::string(host)) + ":" + port;
}

bool isLoopback(const SocketAddress& address) {
  if (address.storage.ss_family == AF_INET6)
    return IN6_IS_ADDR_LOOPBACK(&reinterpret_cast<const sockaddr_in6&>(address.storage).sin6_addr);
  const auto& v4 = reinterpret_cast<const sockaddr_in&>(address.storage);
  return ntohl(v4.sin_addr.s_addr) >> 24 == IN_LOOPBACKNET;
}

SocketAddress resolve(const Address& address) {
  addrinfo hints{}, *found = nullptr;
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_PASSIVE;
  const int fault = getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &hints, &found);
  if (fault != 0) throw std::invalid_argument("'" + address.host + "': " + gai_strerror(fault));
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owner(found, freeaddrinfo);
  SocketAddress resolved;
  std::memcpy(&resolved.storage, found->ai_addr, found->ai_addrlen);
  resolved.size = found->ai_addrlen;
  return resolved;
}

}  // namespace

Address parseAddress(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  const auto fail = [&] {
    throw std::invalid_argument("'" + text + "' is not ADDRESS:PORT, such as 127.0.0.1:7777 or [::1]:7777");
  };
  if (colon == text.npos || colon == 0) fail();
  Address address{text.substr(0, colon)};
  const bool brackets = address.host.starts_with('[') && address.host.ends_with(']');
  if (brackets) address.host = address.host.substr(1, address.host.size() - 2);
  if (!brackets && address.host.find(':') != text.npos) fail();
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data() + colon + 1, end, address.port);
  if (error != std::errc() || rest != end) fail();
  return address;
}

Listener::Listener(const Address& address) {
  SocketAddress wanted = resolve(address);
  const int family = wanted.storage.ss_family, on = 1;
  socket_ = Descriptor(socket(family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (socket_.number() >= 0) setsockopt(socket_.number(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  if (socket_.number() < 0 || bind(socket_.number(), wanted.get(), wanted.size) != 0)
    throw std::invalid_argument("'" + nameOf(wanted) + "' cannot be used: " + std::strerror(errno));
  SocketAddress taken;
  getsockname(socket_.number(), taken.get(), &taken.size);
  name_ = nameOf(taken);
  loopback_ = isLoopback(taken);
}

void Listener::listen() const {
  if (::listen(socket_.number(), kWaiting) != 0)
    throw std::system_error(errno, std::generic_category(), name_);
}

std::optional<Connection> Listener::accept() const {
  SocketAddress peer;
  Descriptor socket(accept4(socket_.number(), peer.get(), &peer.size, SOCK_NONBLOCK | SOCK_CLOEXEC));
  if (socket.number() < 0) return std::nullopt;
  const int on = 1;
  setsockopt(socket.number(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  return Connection{std::move(socket), nameOf(peer)};
}

}  // namespace saccade::client::dv
