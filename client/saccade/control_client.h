// Sends requests to the control socket of a server; each returns its reply or throws.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

#include "saccade/key_watch.h"
#include "saccade/socket.h"
#include "saccade/v1/control.pb.h"

namespace saccade::client {

// No reply came before the deadline. explainSilence() finds out why.
struct NoAnswer : std::runtime_error {
  NoAnswer(const std::string& endpoint, bool has_keys);
  std::string endpoint;
  bool has_keys;  // of the client
};

// The server refused the request. what() is the field at fault, if any, and the message.
struct Refused : std::runtime_error {
  explicit Refused(const v1::Status& status);
  v1::Code code;
  std::string field, message;
};

// Called several times a second during a wait; an exception from it ends the wait.
using Waiting = std::function<void()>;

// Called about once a second with what the server does for an open_stream that takes long. With it a call
// ends with Refused of CODE_UNAVAILABLE where the server no longer knows of it.
using Watching = std::function<void(const v1::OpeningInfo&)>;

v1::Request listStreams();

class ControlClient {
 public:
  static constexpr std::chrono::seconds kDeadline{3};  // for calls that need no rendering or loading

  // Does not wait for the server. Throws std::invalid_argument for a malformed endpoint or key.
  ControlClient(zmq::context_t& context, const std::string& endpoint, const CurveKeys& keys = {});

  // Sends a request and waits for its reply; late replies to earlier requests are ignored. A request made
  // before the server is up reaches it when it comes up. Throws NoAnswer, Refused, std::invalid_argument for
  // a text that is not UTF-8, and std::runtime_error for a reply that is unreadable or has no result. Throws
  // Refused of CODE_PERMISSION_DENIED where the server refuses the key.
  v1::Reply call(v1::Request request, std::chrono::milliseconds deadline = kDeadline,
                 const Waiting& waiting = {}, const Watching& watching = {});

  // Sends a request without waiting for its reply.
  void tell(v1::Request request);

  const std::string& endpoint() const { return endpoint_; }
  const CurveKeys& keys() const { return keys_; }

 private:
  bool send(v1::Request request);  // false: the server has cut the connection off, for good
  void requireKey();
  v1::Reply await(std::uint64_t request_id, std::chrono::milliseconds deadline, const Waiting& waiting,
                  const Watching& watching);

  std::string endpoint_;
  CurveKeys keys_;
  std::optional<KeyWatch> key_watch_;  // with keys
  zmq::socket_t socket_;
  std::uint64_t request_id_;  // of the last request; the first is random, so that it is nobody else's
};

}  // namespace saccade::client
