// HTTP as plain as a socket can speak it.
#pragma once

#include <string>

namespace saccade {

struct HttpReply {
  int status = 0;  // 0: no answer
  std::string head, body;
};

// What http://127.0.0.1:port sends back for `request`; by itself a GET of a path.
HttpReply httpSend(const std::string& endpoint, const std::string& request);
HttpReply httpGet(const std::string& endpoint, const std::string& path);

}  // namespace saccade
