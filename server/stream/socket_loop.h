// One ZeroMQ socket and the thread that owns it. The only place where ZeroMQ is used.
//
// Peers are strangers: what one may send, and what waits for it, is bounded here and in the libzmq that
// deploy/libzmq builds. deploy/THREAT_MODEL.md says against whom.
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

// Only clients with a key on the list may connect, over CURVE.
struct ServerKeys {
  std::string secret;  // the server's own
  std::shared_ptr<ClientKeys> clients;
};

// Who may connect to a socket, and how often.
struct Access {
  std::optional<ServerKeys> keys;  // none: everybody may connect
  int connections = 1024;          // at once
  int client_connections = 512;    // of one key, or of one address where there are no keys
  int inbound_mib = 256;           // messages on their way in, of all sockets of the process
};

struct SocketOptions {
  std::string endpoint;                    // port 0 or * takes a free one; IPv6 where the host is in brackets
  bool for_subscribers = false;            // SUB sockets connect; else DEALERs
  std::int64_t max_part_bytes = 64 << 10;  // a peer that sends a larger part is disconnected
  int send_queue = 64;                     // messages that wait for one peer
  std::size_t send_queue_bytes = 16 << 20;  // and their bytes, but for the last message
  Access access;
};

class SocketLoop {
 public:
  struct Message {
    std::string peer;                // the connection it came by
    std::string user;                // the peer's public key; empty without keys
    std::vector<std::string> parts;  // at most kMaxParts: a peer that sends more is disconnected
  };
  static constexpr int kMaxParts = 2;

  using OnMessage = std::function<void(Message&&)>;
  // Called after messages and wake-ups. Returns the longest time to sleep before the next call.
  using OnTurn = std::function<std::chrono::milliseconds()>;
  using OnGone = std::function<void(const std::string& peer)>;  // the connection has ended
  static constexpr std::chrono::milliseconds kUntilWoken{-1};

  // Binds; throws std::runtime_error naming the endpoint, also where there are keys and a stranger is let in,
  // and where libzmq has no bounds for peers.
  explicit SocketLoop(const SocketOptions& options);
  ~SocketLoop();
  SocketLoop(const SocketLoop&) = delete;
  SocketLoop& operator=(const SocketLoop&) = delete;

  const std::string& endpoint() const { return endpoint_; }  // with the real port
  // When the thread last went around; a wake-up makes it do so. From any thread.
  std::chrono::steady_clock::time_point lastTurn() const;
  WakeFd& wake() { return wake_; }
  // What a call throws is logged, and costs no more than its message.
  void start(OnMessage on_message, OnTurn on_turn, OnGone on_gone);
  // Ends the thread, sends what was accepted for at most a second, and closes the socket.
  void stop();

  // A part that is copied, or one that is shared until it has been sent.
  struct Part {
    Part(std::string_view bytes) : bytes(bytes) {}
    Part(const std::string& bytes) : bytes(bytes) {}
    Part(std::shared_ptr<const std::string> text) : bytes(*text), owner(std::move(text)) {}
    std::string_view bytes;
    std::shared_ptr<const std::string> owner;
  };
  // From the loop's own thread. kFull: the peer does not read; kGone: there is no such peer any more.
  enum class Sent { kYes, kFull, kGone };
  Sent send(const std::string& peer, std::initializer_list<Part> parts);
  // A key may have been taken off the list since its owner connected.
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

// Connections that were refused, or cut for what they sent, since the process started.
int refusedConnections();

}  // namespace saccade
