// HTTP as plain as a socket can speak it.
#pragma once

#include <string>

namespace saccade {

struct HttpReply {
  int status = 0;  // 0: no answer
  std::string head, body;
};

// The answer of http://127.0.0.1:port to `request`; by default that is a GET of a path.
HttpReply httpSend(const std::string& endpoint, const std::string& request);
HttpReply httpGet(const std::string& endpoint, const std::string& path);

}  // namespace saccade
