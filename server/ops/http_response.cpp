#include "ops/http_response.h"

#include <exception>

namespace saccade {
namespace {

struct RequestLine {
  std::string_view method, target, version;
};

RequestLine split(std::string_view head) {
  const std::string_view line = head.substr(0, head.find("\r\n"));
  const std::size_t first = line.find(' '), last = line.rfind(' ');
  if (first == line.npos || first == last) return {};
  return {line.substr(0, first), line.substr(first + 1, last - first - 1), line.substr(last + 1)};
}

const char* reason(int status) {
  switch (status) {
    case 200:
      return "OK";
    case 400:
      return "Bad Request";
    case 404:
      return "Not Found";
    case 405:
      return "Method Not Allowed";
    case 431:
      return "Request Header Fields Too Large";
    case 503:
      return "Service Unavailable";
    default:
      return "Internal Server Error";
  }
}

HttpAnswer fault(int status) {
  return {.status = status, .body = std::string(reason(status)) + "\n"};
}

HttpAnswer answer(const RequestLine& line, const HttpPages& pages) {
  if (!line.version.starts_with("HTTP/1.")) return fault(400);
  if (line.method != "GET" && line.method != "HEAD") return fault(405);
  const auto page = pages.find(std::string(line.target.substr(0, line.target.find('?'))));
  if (page == pages.end()) return fault(404);
  try {
    return page->second();
  } catch (const std::exception&) {
    return fault(500);
  }
}

std::string text(const HttpAnswer& answer, bool with_body) {
  return "HTTP/1.1 " + std::to_string(answer.status) + " " + reason(answer.status) +
         "\r\nContent-Type: " + answer.type + "\r\nContent-Length: " + std::to_string(answer.body.size()) +
         (answer.status == 405 ? "\r\nAllow: GET, HEAD" : "") +
         "\r\nCache-Control: no-store\r\nConnection: close\r\n\r\n" + (with_body ? answer.body : "");
}

}  // namespace

std::string httpResponse(std::string_view head, const HttpPages& pages) {
  const RequestLine line = split(head);
  return text(answer(line, pages), line.method != "HEAD");
}

std::string httpTooLong() {
  return text(fault(431), true);
}

}  // namespace saccade
