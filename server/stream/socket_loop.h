// One ZeroMQ socket and the thread that owns it. The only place where ZeroMQ is used.
//
// Peers are untrusted: this class and the libzmq that deploy/libzmq builds bound what one may send, and what
// waits for it. deploy/THREAT_MODEL.md names the attackers.
#pragma once

#include <chrono>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stream/message_part.h"
#include "stream/socket_options.h"
#include "stream/wake_fd.h"

namespace saccade {

// The answer to a message that is `revoked`.
inline constexpr const char* kRevokedKey = "your key is no longer on the list of the server";

class SocketLoop {
 public:
  struct Message {
    std::string peer;                // name of its connection
    std::string user;                // the peer's public key; empty without keys
    std::vector<MessagePart> parts;  // with their owners; at most kMaxParts of strict_router.h
    std::string former;              // a peer that this one shows to be gone; empty: none
    bool revoked = false;            // the key has been taken off the list since the peer connected
  };

  using OnMessage = std::function<void(Message&&)>;
  // Called after messages and wake-ups. Returns the longest time to sleep before the next call.
  using OnTurn = std::function<std::chrono::milliseconds()>;
  using OnGone = std::function<void(const std::string& peer)>;  // the connection has ended
  static constexpr std::chrono::milliseconds kUntilWoken{-1};

  // Binds. Throws std::runtime_error naming the endpoint where that fails. Throws as well where a socket with
  // keys lets an unknown client in, or libzmq has no bounds for peers.
  explicit SocketLoop(const SocketOptions& options);
  ~SocketLoop();
  SocketLoop(const SocketLoop&) = delete;
  SocketLoop& operator=(const SocketLoop&) = delete;

  const std::string& endpoint() const { return endpoint_; }  // with the real port
  // When the thread last completed a loop; a wake-up makes it do one. From any thread.
  std::chrono::steady_clock::time_point lastTurn() const;
  WakeFd& wake() { return wake_; }
  // Starts the thread, which makes these calls. An exception of a call is logged, and loses only its message.
  void start(OnMessage on_message, OnTurn on_turn, OnGone on_gone);
  // Ends the thread, sends what was accepted for at most a second, and closes the socket.
  void stop();

  // From the loop's own thread, without blocking. Parts without an owner are copied, others are shared until
  // they have been sent. kFull: the peer does not read; kGone: it has disconnected.
  enum class Sent { kYes, kFull, kGone };
  Sent send(const std::string& peer, std::initializer_list<MessagePart> parts);
  // Whether the key is on the list now: it may have been removed since its owner connected.
  bool allows(const std::string& user) const;

 private:
  struct Impl;  // keeps zmq.hpp out of the header
  void run(const OnMessage& on_message, const OnTurn& on_turn, const OnGone& on_gone);
  void receiveSome(const OnMessage& on_message, const OnGone& on_gone);
  void deliver(Message&& message, const OnMessage& on_message, const OnGone& on_gone);

  WakeFd wake_;
  std::unique_ptr<Impl> impl_;
  std::string endpoint_;
};

}  // namespace saccade
