#include "app/config/keys.h"

#include <stdexcept>

#include "stream/endpoint.h"
#include "wire/curve_key.h"

namespace saccade {
namespace {

void requireLoopback(const std::string& option, const std::string& endpoint) {
  if (isLoopback(endpoint)) return;
  throw std::runtime_error(
      option + ": " + endpoint +
      " is open to other machines: give --secret-key and --client-keys, or --insecure to let every machine "
      "that reaches it in");
}

std::optional<ServerKeys> openKeys(const Config& config) {
  if (config.secret_key.empty() != config.client_keys.empty()) {
    throw std::runtime_error("--secret-key and --client-keys belong together");
  }
  if (!config.secret_key.empty() && config.insecure) {
    throw std::runtime_error("--insecure contradicts --secret-key and --client-keys: give one or the other");
  }
  if (!config.secret_key.empty()) {
    return ServerKeys{readCurveKey(config.secret_key), std::make_shared<ClientKeys>(config.client_keys)};
  }
  if (!config.insecure) {
    requireLoopback("--control", config.control);
    requireLoopback("--data", config.data);
    requireLoopback("--broadcast", config.broadcast);
  }
  return std::nullopt;
}

}  // namespace

Access openAccess(const Config& config) {
  const auto whole = [&](Limit limit) { return static_cast<int>(config.limits[limit]); };
  return {.keys = openKeys(config),
          .connections = whole(Limit::kConnections),
          .client_connections = whole(Limit::kClientConnections),
          .inbound_mib = whole(Limit::kInbound)};
}

}  // namespace saccade
