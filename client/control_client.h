// The control plane as a client sees it: a request, then its reply or an exception.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

#include "client/socket.h"
#include "saccade/v1/control.pb.h"

namespace saccade::client {

// No reply came before the deadline.
struct NoAnswer : std::runtime_error {
  using runtime_error::runtime_error;
};

// The server said no; what() is its message, with the field in front where it named one.
struct Refused : std::runtime_error {
  explicit Refused(const v1::Status& status);
  v1::Code code;
};

// Called several times a second while something is waited for; what it throws ends the wait.
using Waiting = std::function<void()>;

class ControlClient {
 public:
  static constexpr std::chrono::seconds kDeadline{3};  // for what the server answers at once

  // Does not wait for the server. Throws std::invalid_argument where `endpoint` or a key is not one.
  ControlClient(zmq::context_t& context, const std::string& endpoint, const CurveKeys& keys = {});

  // Sends and waits for the reply to this very request; late replies to earlier ones are passed over. A
  // request made before the server is up reaches it when it comes up. Throws NoAnswer, Refused,
  // std::invalid_argument where a text of the request is no UTF-8, and std::runtime_error where a reply
  // cannot be read.
  v1::Reply call(v1::Request request, std::chrono::milliseconds deadline = kDeadline,
                 const Waiting& waiting = {});

  // Sends and does not wait: what the reply says is of no interest, or nobody may be there to give one.
  void tell(v1::Request request);

  const std::string& endpoint() const { return endpoint_; }
  const CurveKeys& keys() const { return keys_; }

 private:
  void send(v1::Request request);
  v1::Reply await(std::uint64_t request_id, std::chrono::milliseconds deadline, const Waiting& waiting);

  std::string endpoint_;
  CurveKeys keys_;
  zmq::socket_t socket_;
  std::uint64_t request_id_ = 0;
};

}  // namespace saccade::client
