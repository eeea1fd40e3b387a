#include "stream/endpoint.h"

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

std::string reachableHere(const std::string& endpoint) {
  const auto [scheme, host, port] = split(endpoint);
  if (host == "0.0.0.0") return scheme + "://127.0.0.1" + port;
  if (host == "[::]") return scheme + "://[::1]" + port;
  return endpoint;
}

}  // namespace saccade
