#include "app/config/keys.h"

#include <spdlog/spdlog.h>

#include <stdexcept>
#include <utility>

#include "saccade/wire/curve_key.h"
#include "stream/bounded_peers.h"
#include "stream/endpoint.h"
#include "stream/public_key.h"

namespace saccade {
namespace {

// Also warns where others can read it.
std::string openSecretKey(const std::string& path) {
  std::string key = readSecretKey(path);
  const std::string warning = warningOfOpenKey(path);
  if (!warning.empty()) spdlog::warn(warning);
  return key;
}

// Every address of ZeroMQ is for this machine alone, or `advice` says what else to do.
void requireLoopback(const Config& config, const char* advice) {
  const std::pair<const char*, std::string> endpoints[] = {
      {"--control", config.control}, {"--data", config.data}, {"--broadcast", config.broadcast}};
  for (const auto& [option, endpoint] : endpoints) {
    if (isLoopback(endpoint)) continue;
    throw std::runtime_error(std::string(option) + ": " + endpoint +
                             " is not a loopback address such as 127.0.0.1 or localhost" + advice);
  }
}

// Returns what `read` returns, and puts the name of the option before the text of its exception.
auto named(const std::string& option, const auto& read) {
  try {
    return read();
  } catch (const std::exception& fault) {
    throw std::runtime_error(option + ": " + fault.what());
  }
}

std::optional<ServerKeys> openKeys(const Config& config) {
  if (config.secret_key.empty() != config.client_keys.empty()) {
    throw std::runtime_error("--secret-key and --client-keys belong together");
  }
  if (!config.secret_key.empty() && config.insecure) {
    throw std::runtime_error("--insecure contradicts --secret-key and --client-keys: give one or the other");
  }
  if (!config.secret_key.empty()) {
    return ServerKeys{named("--secret-key", [&] { return openSecretKey(config.secret_key); }),
                      named("--client-keys", [&] {
                        requirePublic(config.client_keys);
                        return std::make_shared<ClientKeys>(config.client_keys);
                      })};
  }
  if (!config.insecure) {
    requireLoopback(config,
                    ": give --secret-key and --client-keys, or --insecure to let every machine that reaches "
                    "it in");
  }
  return std::nullopt;
}

// Viewers without a key of their own would let in whoever has none.
std::optional<client::CurveKeys> viewerKeys(const Config& config, const Access& access) {
  if (!access.keys) {
    if (!config.viewer_key.empty())
      throw std::runtime_error("--viewer-key is for a server with --secret-key and --client-keys");
    return client::CurveKeys{};
  }
  if (config.viewer_key.empty()) return std::nullopt;
  const std::string secret = named("--viewer-key", [&] { return openSecretKey(config.viewer_key); });
  if (!access.keys->clients->allow(publicKeyOf(secret)))
    throw std::runtime_error("--viewer-key: the public key of " + config.viewer_key +
                             " is not one of --client-keys");
  return client::CurveKeys{.secret = secret, .server_public = publicKeyOf(access.keys->secret)};
}

}  // namespace

Access openAccess(const Config& config) {
  if (!peersAreBounded()) {
    requireLoopback(config,
                    ", and this saccaded has the system's libzmq, which bounds nothing that they send: run "
                    "deploy/libzmq/build and build saccaded again");
  }
  const auto whole = [&](Limit limit) { return static_cast<int>(config.limits[limit]); };
  return {.keys = openKeys(config),
          .connections = whole(Limit::kConnections),
          .client_connections = whole(Limit::kClientConnections),
          .inbound_mib = whole(Limit::kInbound)};
}

std::optional<client::CurveKeys> openViewer(const Config& config, const Access& access) {
  if (config.viewer == "off") return std::nullopt;
  const std::optional<client::CurveKeys> keys = viewerKeys(config, access);
  if (config.viewer == "on") {
    if (config.http == "off") throw std::runtime_error("--viewer on needs an address: give --http");
    if (!keys) throw std::runtime_error("--viewer on needs --viewer-key on a server with keys");
    return keys;
  }
  return config.http != "off" && isLoopback(config.http) ? keys : std::nullopt;
}

}  // namespace saccade
