// Tells whether a server refuses the key of a socket.
#pragma once

#include <zmq.hpp>

namespace saccade::client {

class KeyWatch {
 public:
  // Watches a socket that is yet to connect. Throws zmq::error_t.
  KeyWatch(zmq::context_t& context, zmq::socket_t& watched);

  // Whether it has done so. libzmq then tries no more, and sends block for ever.
  bool refused();

 private:
  zmq::socket_t events_;
  bool refused_ = false;
};

}  // namespace saccade::client
