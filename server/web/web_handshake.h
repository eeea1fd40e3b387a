// The handshake of a WebSocket [RFC 6455, section 4.2].
#pragma once

#include "ops/http_upgrade.h"

namespace saccade {

// Status 101 if `header` asks for a WebSocket and comes from a page of this server, else an error. With
// `loopback_only`, Host must be a name of loopback. Else a page of another site could reach the server under
// a name of its own that it lets resolve to 127.0.0.1.
HttpAnswer answerHandshake(const HttpHeader& header, bool loopback_only);

// The Sec-WebSocket-Accept of a Sec-WebSocket-Key.
std::string acceptOf(const std::string& key);

}  // namespace saccade
