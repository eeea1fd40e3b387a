#include "ops/http_server.h"

#include <microhttpd.h>
#include <netdb.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "ops/http_respond.h"

namespace saccade {
namespace {

constexpr std::string_view kScheme = "http://";
constexpr rlim_t kMaxClients = 1024;
constexpr rlim_t kFilesPerClient = 4;  // clients get a quarter of the files that the process may open
constexpr unsigned kMaxConnections = 2 * kMaxClients;  // includes those being cut off
constexpr unsigned kMaxSilenceS = 2;
constexpr std::size_t kMemoryBytes = 8192;  // of a connection: the longest head of a request

using Addresses = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

Addresses resolve(const std::string& endpoint) {
  const std::size_t colon = endpoint.rfind(':');
  if (!endpoint.starts_with(kScheme) || colon < kScheme.size())
    throw std::runtime_error(endpoint + " is not an address such as http://127.0.0.1:5773");
  std::string host = endpoint.substr(kScheme.size(), colon - kScheme.size());
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  addrinfo hints{};
  hints.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int fault = getaddrinfo(host.c_str(), endpoint.c_str() + colon + 1, &hints, &found);
  if (fault != 0) throw std::runtime_error("cannot listen on " + endpoint + ": " + gai_strerror(fault));
  return {found, freeaddrinfo};
}

// Why libmicrohttpd could not listen there: some versions leave another fault in errno.
std::string faultOf(const addrinfo& address) {
  const int probe = socket(address.ai_family, address.ai_socktype | SOCK_CLOEXEC, 0);
  if (probe < 0) return std::strerror(errno);
  const int fault = bind(probe, address.ai_addr, address.ai_addrlen) == 0 ? 0 : errno;
  close(probe);
  return fault == 0 ? "libmicrohttpd does not start" : std::strerror(fault);
}

std::string withPortOf(MHD_Daemon* daemon, const std::string& endpoint) {
  const auto port = MHD_get_daemon_info(daemon, MHD_DAEMON_INFO_BIND_PORT)->port;
  return endpoint.substr(0, endpoint.rfind(':') + 1) + std::to_string(port);
}

rlim_t maxClients() {
  rlimit files{};
  getrlimit(RLIMIT_NOFILE, &files);
  return std::min(kMaxClients, files.rlim_cur / kFilesPerClient);
}

// Counts the clients, and cuts off the oldest of too many: one that sends a byte now and then is never
// silent.
void count(void* site, MHD_Connection* client, void**, MHD_ConnectionNotificationCode code) {
  auto& clients = static_cast<HttpSite*>(site)->clients;
  const int socket = MHD_get_connection_info(client, MHD_CONNECTION_INFO_CONNECTION_FD)->connect_fd;
  if (code == MHD_CONNECTION_NOTIFY_CLOSED) {
    std::erase(clients, socket);
    return;
  }
  clients.push_back(socket);
  if (clients.size() <= maxClients()) return;
  shutdown(clients.front(), SHUT_RDWR);
  clients.erase(clients.begin());
}

}  // namespace

HttpServer::HttpServer(const std::string& endpoint, HttpPages pages, HttpUpgrades upgrades)
    : site_{std::move(pages), std::move(upgrades)},
      daemon_(start(endpoint)),
      endpoint_(withPortOf(daemon_.get(), endpoint)) {}

// Uses poll(): with epoll libmicrohttpd 0.9.75 misses a connection's end that comes with its last bytes.
HttpServer::Daemon HttpServer::start(const std::string& endpoint) {
  const Addresses address = resolve(endpoint);
  const unsigned family = address->ai_family == AF_INET6 ? MHD_USE_IPv6 : MHD_NO_FLAG;
  // clang-format off
  Daemon daemon(MHD_start_daemon(MHD_USE_POLL_INTERNAL_THREAD | MHD_ALLOW_UPGRADE | family, 0, nullptr, nullptr,
                                 respond, &site_,
                                 MHD_OPTION_SOCK_ADDR, address->ai_addr,
                                 MHD_OPTION_CONNECTION_LIMIT, kMaxConnections,
                                 MHD_OPTION_CONNECTION_MEMORY_LIMIT, kMemoryBytes,
                                 MHD_OPTION_CONNECTION_TIMEOUT, kMaxSilenceS,
                                 MHD_OPTION_NOTIFY_CONNECTION, count, &site_,
                                 MHD_OPTION_END),
                MHD_stop_daemon);
  // clang-format on
  if (!daemon) throw std::runtime_error("cannot listen on " + endpoint + ": " + faultOf(*address));
  return daemon;
}

}  // namespace saccade
