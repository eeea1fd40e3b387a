// Answers libzmq's question whether a client may connect [ZeroMQ RFC 27, ZAP], on a thread of its own.
#pragma once

#include <memory>
#include <string>
#include <thread>
#include <vector>
#include <zmq.hpp>

#include "stream/client_keys.h"
#include "stream/wake_fd.h"

namespace saccade {

// The answer to one request, both in the parts of the RFC: 200 to a client of mechanism CURVE whose key is
// allowed, with the key as its User-Id, and 400 to everything else.
std::vector<std::string> answerZap(const std::vector<std::string>& request, const ClientKeys& clients);

// For all sockets of `context` that secureServer() has been called on. To be made before they are bound.
class ZapHandler {
 public:
  ZapHandler(zmq::context_t& context, std::shared_ptr<const ClientKeys> clients);
  ~ZapHandler();

 private:
  void run();

  const std::shared_ptr<const ClientKeys> clients_;
  zmq::socket_t socket_;
  WakeFd stop_;
  std::thread thread_;
};

// Lets only clients through that know the server's public key, and that the handler allows. Without a handler
// nobody comes in.
void secureServer(zmq::socket_t& socket, const std::string& secret_key);

}  // namespace saccade
