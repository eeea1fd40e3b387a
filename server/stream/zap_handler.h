// Tells libzmq which clients may connect [ZeroMQ RFC 27, ZAP], on a thread of its own.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>
#include <zmq.hpp>

#include "log/limited_log.h"
#include "stream/client_keys.h"
#include "stream/wake_fd.h"

namespace saccade {

// The answer to one request, both in the parts of the RFC. A CURVE client whose key is allowed gets 200, with
// the key as its User-Id; anything else gets 400.
std::vector<std::string> answerZap(const std::vector<std::string>& request, const ClientKeys& clients);

// Serves all sockets of `context` on which secureServer() was called. Make it before they are bound.
class ZapHandler {
 public:
  ZapHandler(zmq::context_t& context, std::shared_ptr<ClientKeys> clients);
  ~ZapHandler();
  // From now on counts the connections that it refuses, and logs them as lines that clients cause.
  void tellRefusals() { telling_ = true; }

 private:
  void run();
  void tell(const std::vector<std::string>& request);

  const std::shared_ptr<ClientKeys> clients_;
  LimitedLog log_;
  std::atomic<bool> telling_ = false;
  zmq::socket_t socket_;
  WakeFd stop_;
  std::thread thread_;
};

// Lets a socket accept only clients that know the server's public key and that the handler allows. Without a
// handler it accepts none.
void secureServer(zmq::socket_t& socket, const std::string& secret_key);

}  // namespace saccade
