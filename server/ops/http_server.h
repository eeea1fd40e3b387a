// Serves pages over HTTP, such as metrics and health.
//
// One thread serves all clients and waits for none. It cuts off silent clients, and the oldest of too many.
// Connections that have left HTTP are no clients any more.
#pragma once

#include <memory>
#include <string>

#include "ops/http_site.h"

struct MHD_Daemon;

namespace saccade {

class HttpServer {
 public:
  // Listens on `endpoint`, such as http://127.0.0.1:5773 or http://[::1]:5773; port 0 takes a free one.
  // Throws std::runtime_error. A thread of the server calls the pages.
  HttpServer(const std::string& endpoint, HttpPages pages, HttpUpgrades upgrades = {});

  const std::string& endpoint() const { return endpoint_; }  // with the real port

 private:
  using Daemon = std::unique_ptr<MHD_Daemon, void (*)(MHD_Daemon*)>;
  Daemon start(const std::string& endpoint);

  HttpSite site_;
  const Daemon daemon_;
  const std::string endpoint_;
};

}  // namespace saccade
