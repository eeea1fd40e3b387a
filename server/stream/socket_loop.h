// One ZeroMQ socket and the thread that owns it. The only place where ZeroMQ is used.
#pragma once

#include <chrono>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "stream/wake_fd.h"

namespace saccade {

struct SocketOptions {
  enum class Kind { kRouter, kXPub };
  Kind kind = Kind::kRouter;
  std::string endpoint;                    // port 0 or * takes a free one; IPv6 where the host is in brackets
  std::int64_t max_part_bytes = 64 << 10;  // a peer that sends a larger part is disconnected
  int send_queue = 64;                     // messages per peer
};

class SocketLoop {
 public:
  using Parts = std::vector<std::string>;
  // A router's messages begin with the peer's identity. Parts beyond the third are thrown away.
  using OnMessage = std::function<void(Parts)>;
  // Called after messages and wake-ups. Returns the longest time to sleep before the next call.
  using OnTurn = std::function<std::chrono::milliseconds()>;
  static constexpr std::chrono::milliseconds kUntilWoken{-1};

  explicit SocketLoop(const SocketOptions& options);  // binds; throws std::runtime_error naming the endpoint
  ~SocketLoop();
  SocketLoop(const SocketLoop&) = delete;
  SocketLoop& operator=(const SocketLoop&) = delete;

  const std::string& endpoint() const { return endpoint_; }  // with the real port
  WakeFd& wake() { return wake_; }
  void start(OnMessage on_message, OnTurn on_turn);
  // Ends the thread, sends what was accepted for at most a second, and closes the socket.
  void stop();

  // From the loop's own thread. kFull: the peer does not read; kGone: there is no such peer any more.
  enum class Sent { kYes, kFull, kGone };
  Sent send(std::initializer_list<std::string_view> parts);
  void setSubscription(const std::string& topic, bool wanted);  // of the peer that sent the last message

 private:
  struct Impl;  // keeps zmq.hpp out of the header
  void run(const OnMessage& on_message, const OnTurn& on_turn);

  WakeFd wake_;
  std::unique_ptr<Impl> impl_;
  std::string endpoint_;
};

}  // namespace saccade
