// The viewers of a server: bounded in number, each on a thread of its own, so that a slow one delays nobody.
#pragma once

#include <atomic>
#include <list>
#include <mutex>
#include <string>
#include <thread>
#include <zmq.hpp>

#include "log/limited_log.h"
#include "ops/http_upgrade.h"
#include "web/viewer_stream.h"

namespace saccade {

struct ViewerSettings {
  std::string control;  // endpoint
  ViewerStream::Source source;
  std::size_t max_viewers = 1;
  bool loopback_only = true;  // see answerHandshake()
};

class ViewerGateway {
 public:
  static constexpr const char* kPath = "/viewer";  // of the WebSocket

  explicit ViewerGateway(ViewerSettings settings);
  ~ViewerGateway();  // stop()

  HttpUpgrade upgrade();
  // Ends all viewers and takes no more. Their sockets are closed when it returns.
  void stop();
  std::size_t viewers() const;

 private:
  struct Seat {
    std::atomic<bool> done = false;
    std::jthread thread;
  };
  HttpAnswer answer(const HttpHeader& header) const;
  void take(UpgradedSocket socket);
  void serve(UpgradedSocket socket, std::stop_token stopped);

  const ViewerSettings settings_;
  zmq::context_t context_;
  LimitedLog log_;
  mutable std::mutex mutex_;
  std::list<Seat> seats_;
  bool stopped_ = false;
};

}  // namespace saccade
