// The control socket as a test sees it.
#pragma once

#include <chrono>
#include <string>
#include <zmq.hpp>

#include "mock/mock_keys.h"
#include "saccade/v1/control.pb.h"

namespace saccade {

inline constexpr std::chrono::milliseconds kPatience{30000};  // no test waits longer for one message

class MockClient {
 public:
  explicit MockClient(const std::string& control_endpoint, const MockKeys& keys = {});

  v1::Reply call(v1::Request request);          // adds request_id and version; checks that the id comes back
  v1::Reply callRaw(const std::string& bytes);  // throws std::runtime_error where no reply comes
  v1::StreamOpened open(const v1::OpenStream& r);  // throws std::runtime_error where refused
  v1::Status tryOpen(const v1::OpenStream& request);
  v1::Status close(const v1::StreamOpened& stream);
  v1::StreamList streams();                           // those of this client
  v1::StreamInfo info(const std::string& stream_id);  // empty where it is not listed
  v1::ServerDescription server();
  void setPatience(std::chrono::milliseconds patience);  // for one reply; kPatience at first

 private:
  zmq::context_t context_;
  zmq::socket_t socket_;
  std::uint64_t request_id_ = 0;
};

}  // namespace saccade
