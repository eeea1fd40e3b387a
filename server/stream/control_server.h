// The control socket: one Request, one Reply.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "saccade/v1/control.pb.h"
#include "stream/request_counts.h"
#include "stream/socket_loop.h"

namespace saccade {

v1::Status okStatus();
v1::Status makeStatus(v1::Code code, const std::string& message, const std::string& field = {});

// Reads `request` from the parts of a message. Returns why it cannot be handed on, or OK.
v1::Status readRequest(const std::vector<std::string>& parts, v1::Request& request);

class ControlServer {
 public:
  // To be called once, from any thread, soon or late; the reply's request_id is filled in.
  using Answer = std::function<void(v1::Reply)>;
  // Called on the control thread with a request that has a call and the right version, and with the public
  // key of who asks, empty without keys; must not block.
  using Handler = std::function<void(const v1::Request&, const std::string& user, Answer)>;

  // Binds; throws std::runtime_error. Adds every answer to `counts`, which outlives the answers. A peer that
  // sends more than `max_bytes` at once is disconnected.
  ControlServer(const std::string& endpoint, std::int64_t max_bytes, RequestCounts& counts,
                const Access& access = {});
  // Answers may still be called after the server is gone; they then go nowhere.
  ~ControlServer();

  std::string endpoint() const { return loop_->endpoint(); }
  WakeFd& wake() { return loop_->wake(); }
  auto lastTurn() const { return loop_->lastTurn(); }
  void start(Handler handler);
  void stop();

 private:
  struct Outbox;
  void receive(const SocketLoop::Message& message);
  void sendReplies();

  RequestCounts& counts_;
  std::shared_ptr<SocketLoop> loop_;
  std::shared_ptr<Outbox> outbox_;
  Handler handler_;
};

}  // namespace saccade
