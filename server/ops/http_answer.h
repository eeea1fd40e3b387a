// The answer of the HTTP server to a request.
#pragma once

#include <map>
#include <string>

namespace saccade {

struct HttpAnswer {
  int status = 200;
  std::string type = "text/plain; charset=utf-8", body = {};
  std::map<std::string, std::string> headers = {};  // further ones
};

}  // namespace saccade
