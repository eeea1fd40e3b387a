#include "web/connection_watch.h"

#include <atomic>
#include <string>

namespace saccade {

ConnectionWatch::ConnectionWatch(zmq::context_t& context, zmq::socket_t& watched)
    : ends_(context, zmq::socket_type::pair) {
  static std::atomic<unsigned long> watches = 0;
  const std::string name = "inproc://watch-" + std::to_string(watches++);
  if (zmq_socket_monitor(watched.handle(), name.c_str(), ZMQ_EVENT_DISCONNECTED) != 0) throw zmq::error_t();
  ends_.set(zmq::sockopt::linger, 0);
  ends_.connect(name);
}

bool ConnectionWatch::lost() {
  zmq::message_t end;
  return ends_.recv(end, zmq::recv_flags::dontwait).has_value();
}

}  // namespace saccade
