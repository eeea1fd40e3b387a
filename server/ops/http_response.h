// What a request for a page is answered. A small part of HTTP [RFC 9112]: GET and HEAD of what has a name.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace saccade {

struct HttpAnswer {
  int status = 200;
  std::string type = "text/plain; charset=utf-8", body;
};

using HttpPage = std::function<HttpAnswer()>;
using HttpPages = std::map<std::string, HttpPage>;  // by path, such as "/healthz"

inline constexpr std::string_view kHttpHeadEnd = "\r\n\r\n";

// All that goes back for a request whose lines up to the empty one are `head`. What a page throws is a 500.
std::string httpResponse(std::string_view head, const HttpPages& pages);
// To who sends a longer head than is read.
std::string httpTooLong();

}  // namespace saccade
