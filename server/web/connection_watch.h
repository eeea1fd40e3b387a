// Tells when a socket has lost its connection: libzmq connects again by itself, but what belonged to the
// connection is gone.
#pragma once

#include <zmq.hpp>

namespace saccade {

class ConnectionWatch {
 public:
  // From now on. Throws zmq::error_t.
  ConnectionWatch(zmq::context_t& context, zmq::socket_t& watched);

  bool lost();  // since the last call

 private:
  zmq::socket_t ends_;
};

}  // namespace saccade
