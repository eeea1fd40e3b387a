// The address that the HTTP server listens on.
#pragma once

#include <string>

namespace saccade {

// A socket that listens on an endpoint such as http://127.0.0.1:5773 or http://[::1]:5773, and whose accept()
// does not block; port 0 takes a free one. Throws std::runtime_error.
int listenForHttp(const std::string& endpoint);
// `endpoint` with the real port of `listener`.
std::string withPortOf(int listener, const std::string& endpoint);

}  // namespace saccade
