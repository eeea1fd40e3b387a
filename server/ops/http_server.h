// A few pages over HTTP, for machines that watch: metrics and health.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

namespace saccade {

struct HttpAnswer {
  int status = 200;
  std::string type = "text/plain; charset=utf-8", body;
};

class HttpServer {
 public:
  using Page = std::function<HttpAnswer()>;   // called from any of the server's threads
  using Pages = std::map<std::string, Page>;  // by path, such as "/healthz"

  // Listens on `endpoint`, such as http://127.0.0.1:5773; port 0 takes a free one. Throws std::runtime_error.
  HttpServer(const std::string& endpoint, Pages pages);
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  const std::string& endpoint() const { return endpoint_; }  // with the real port

 private:
  struct Impl;  // keeps civetweb out of the header
  std::unique_ptr<Impl> impl_;
  std::string endpoint_;
};

}  // namespace saccade
