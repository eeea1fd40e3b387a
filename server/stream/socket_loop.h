// One ZeroMQ socket and the thread that owns it. The only place where ZeroMQ is used.
#pragma once

#include <chrono>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stream/client_keys.h"
#include "stream/wake_fd.h"

namespace saccade {

// Only who has a key on the list may connect, over CURVE.
struct ServerKeys {
  std::string secret;  // the server's own
  std::shared_ptr<ClientKeys> clients;
};

struct SocketOptions {
  enum class Kind { kRouter, kXPub };
  Kind kind = Kind::kRouter;
  std::string endpoint;                    // port 0 or * takes a free one; IPv6 where the host is in brackets
  std::int64_t max_part_bytes = 64 << 10;  // a peer that sends a larger part is disconnected
  int send_queue = 64;                     // messages per peer
  std::optional<ServerKeys> keys;          // none: everybody may connect
};

// Whether ZeroMQ itself has named this peer of a router. A peer that names itself has no name of its own:
// whoever connects under it next, when the first one is gone, has its replies and its packets.
bool hasServersName(const std::string& identity);
inline constexpr const char* kNamedItself = "leave the socket's routing id (identity) unset";

class SocketLoop {
 public:
  struct Message {
    // A router's begin with the peer's identity. Those beyond the third are thrown away.
    std::vector<std::string> parts;
    std::string user;  // the peer's public key; empty without keys
  };
  using OnMessage = std::function<void(const Message&)>;
  // Called after messages and wake-ups. Returns the longest time to sleep before the next call.
  using OnTurn = std::function<std::chrono::milliseconds()>;
  static constexpr std::chrono::milliseconds kUntilWoken{-1};

  // Binds; throws std::runtime_error naming the endpoint, also where there are keys and a stranger is let in.
  explicit SocketLoop(const SocketOptions& options);
  ~SocketLoop();
  SocketLoop(const SocketLoop&) = delete;
  SocketLoop& operator=(const SocketLoop&) = delete;

  const std::string& endpoint() const { return endpoint_; }  // with the real port
  // When the thread last went around; a wake-up makes it do so. From any thread.
  std::chrono::steady_clock::time_point lastTurn() const;
  WakeFd& wake() { return wake_; }
  void start(OnMessage on_message, OnTurn on_turn);
  // Ends the thread, sends what was accepted for at most a second, and closes the socket.
  void stop();

  // From the loop's own thread. kFull: the peer does not read; kGone: there is no such peer any more.
  enum class Sent { kYes, kFull, kGone };
  Sent send(std::initializer_list<std::string_view> parts);
  // A key may have been taken off the list since its owner connected.
  bool allows(const std::string& user) const;
  void setSubscription(const std::string& topic, bool wanted);  // of the peer that sent the last message

 private:
  struct Impl;  // keeps zmq.hpp out of the header
  void run(const OnMessage& on_message, const OnTurn& on_turn);

  WakeFd wake_;
  std::unique_ptr<Impl> impl_;
  std::string endpoint_;
};

}  // namespace saccade
