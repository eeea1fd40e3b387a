// A few pages over HTTP, for machines that watch: metrics and health. One thread, which waits for no client:
// of many connections the oldest is cut off, and no connection lasts for more than seconds.
#pragma once

#include <list>
#include <string>
#include <thread>

#include "ops/http_connection.h"

namespace saccade {

class HttpServer {
 public:
  // Listens on `endpoint`, such as http://127.0.0.1:5773; port 0 takes a free one. Throws std::runtime_error.
  // The pages are called from a thread of the server's.
  HttpServer(const std::string& endpoint, HttpPages pages);
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  const std::string& endpoint() const { return endpoint_; }  // with the real port

 private:
  void run();
  bool wait() const;
  bool welcome();
  bool makeRoom();

  const HttpPages pages_;
  const int listener_, stop_;  // sockets; an event
  const std::string endpoint_;
  std::list<HttpConnection> clients_;  // the oldest first
  std::thread thread_;
};

}  // namespace saccade
