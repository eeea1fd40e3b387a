// Serves a few pages over HTTP for monitoring: metrics and health.
//
// One thread serves all clients and waits for none. It cuts off silent clients, and the oldest of too many.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

struct MHD_Daemon;

namespace saccade {

struct HttpAnswer {
  int status = 200;
  std::string type = "text/plain; charset=utf-8", body;
};

using HttpPage = std::function<HttpAnswer()>;       // an exception becomes a 500
using HttpPages = std::map<std::string, HttpPage>;  // by path, such as "/healthz"

class HttpServer {
 public:
  // Listens on `endpoint`, such as http://127.0.0.1:5773 or http://[::1]:5773; port 0 takes a free one.
  // Throws std::runtime_error. A thread of the server calls the pages.
  HttpServer(const std::string& endpoint, HttpPages pages);

  const std::string& endpoint() const { return endpoint_; }  // with the real port

 private:
  using Daemon = std::unique_ptr<MHD_Daemon, void (*)(MHD_Daemon*)>;
  Daemon start(const std::string& endpoint);

  HttpPages pages_;
  std::vector<int> clients_;  // their sockets, the oldest first; the daemon's thread alone uses them
  const Daemon daemon_;
  const std::string endpoint_;
};

}  // namespace saccade
