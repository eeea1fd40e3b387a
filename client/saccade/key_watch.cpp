#include "saccade/key_watch.h"

#include <atomic>
#include <string>

namespace saccade::client {

KeyWatch::KeyWatch(zmq::context_t& context, zmq::socket_t& watched)
    : events_(context, zmq::socket_type::pair) {
  static std::atomic<unsigned long> watches = 0;
  const std::string name = "inproc://key-watch-" + std::to_string(watches++);
  if (zmq_socket_monitor(watched.handle(), name.c_str(), ZMQ_EVENT_HANDSHAKE_FAILED_AUTH) != 0)
    throw zmq::error_t();
  events_.set(zmq::sockopt::linger, 0);
  events_.connect(name);
}

bool KeyWatch::refused() {
  zmq::message_t event;
  refused_ = refused_ || events_.recv(event, zmq::recv_flags::dontwait).has_value();
  return refused_;
}

}  // namespace saccade::client
