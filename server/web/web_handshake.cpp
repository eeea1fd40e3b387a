#include "web/web_handshake.h"

#include <nettle/base64.h>
#include <nettle/sha1.h>
#include <strings.h>

#include <array>
#include <string_view>

namespace saccade {
namespace {

constexpr std::string_view kGuid = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";  // [RFC 6455]
constexpr std::size_t kKeyLength = BASE64_ENCODE_RAW_LENGTH(16);

bool fromThisServer(const std::string& origin, const std::string& host) {
  return !host.empty() && (origin == "http://" + host || origin == "https://" + host);
}

bool namesLoopback(std::string host) {
  const auto colon = host.rfind(':');
  if (colon != std::string::npos && !host.ends_with(']')) host.resize(colon);
  return host == "localhost" || host == "127.0.0.1" || host == "[::1]";
}

}  // namespace

std::string acceptOf(const std::string& key) {
  const std::string text = key + std::string(kGuid);
  std::array<std::uint8_t, SHA1_DIGEST_SIZE> digest;
  sha1_ctx sha1;
  sha1_init(&sha1);
  sha1_update(&sha1, text.size(), reinterpret_cast<const std::uint8_t*>(text.data()));
  sha1_digest(&sha1, digest.size(), digest.data());
  std::string accept(BASE64_ENCODE_RAW_LENGTH(SHA1_DIGEST_SIZE), '\0');
  base64_encode_raw(accept.data(), digest.size(), digest.data());
  return accept;
}

HttpAnswer answerHandshake(const HttpHeader& header, bool loopback_only) {
  if (strcasecmp(header("Upgrade").c_str(), "websocket") != 0) {
    return {.status = 426, .body = "the viewer's WebSocket\n", .headers = {{"Upgrade", "websocket"}}};
  }
  const std::string host = header("Host"), key = header("Sec-WebSocket-Key");
  if (!fromThisServer(header("Origin"), host) || (loopback_only && !namesLoopback(host))) {
    return {.status = 403, .body = "only pages of this server may connect\n"};
  }
  if (header("Sec-WebSocket-Version") != "13") {
    return {.status = 426, .body = "WebSocket version 13\n", .headers = {{"Sec-WebSocket-Version", "13"}}};
  }
  if (key.size() != kKeyLength) return {.status = 400, .body = "Sec-WebSocket-Key has 24 characters\n"};
  return {.status = 101, .headers = {{"Upgrade", "websocket"}, {"Sec-WebSocket-Accept", acceptOf(key)}}};
}

}  // namespace saccade
