// The control socket: one Request, one Reply.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "reply/status.h"
#include "saccade/v1/control.pb.h"
#include "stream/answer.h"
#include "stream/raw_request.h"
#include "stream/request_counts.h"
#include "stream/socket_loop.h"
#include "stream/unread.h"

namespace saccade {

// The sender of a request.
struct Peer {
  std::string connection;  // its name on the control socket
  std::string user;        // its public key; empty without keys
  bool admin = false;      // may see and close the streams of all

  // Whether it sees what a user has, where it asks for what all have or for its own.
  bool sees(const std::string& owner, bool all) const { return owner == user || (all && admin); }
};

// Reads the head of a request from the parts of a message. Returns OK, or why it must be refused.
v1::Status readRequest(std::vector<MessagePart>&& parts, RawRequest& request);

class ControlServer {
 public:
  struct Options {
    std::string endpoint;
    std::int64_t request_bytes;            // a peer that sends a longer request is disconnected
    std::int64_t unread_bytes = 16 << 20;  // a peer with more bytes of replies waiting is refused
    Access access = {};
  };
  // A peer with so many replies to come, or to be taken, is refused. Refusals that it does not take either
  // are dropped and counted.
  static constexpr int kMaxUnread = 512;
  // All connections together have room for so many times `unread_bytes`, and those of one key for half of
  // that. Beyond it only short calls of connections without waiting replies are answered.
  static constexpr int kUnreadShares = 16;

  // `answer` sends the reply, whose request_id it fills in. Called on the control thread with a request that
  // has a call and the right version; must not block.
  using Handler = std::function<void(RawRequest request, const Peer& peer, Answer answer)>;
  using OnGone = SocketLoop::OnGone;

  // Binds; throws std::runtime_error. Adds every answer to `counts`, which outlives the answers. Without keys
  // all peers are admins where the endpoint is of loopback, and none elsewhere.
  ControlServer(const Options& options, RequestCounts& counts);
  // An Answer may be called after the server is gone; its reply is then lost.
  ~ControlServer();

  std::string endpoint() const { return loop_->endpoint(); }
  WakeFd& wake() { return loop_->wake(); }
  auto lastTurn() const { return loop_->lastTurn(); }
  // `on_gone` is called on the control thread with the connection of a peer that has gone.
  void start(
      Handler handler, OnGone on_gone = [](const std::string&) {});
  void stop();

 private:
  struct Outbox;
  void receive(SocketLoop::Message&& message);
  Answer answerTo(const std::string& connection, const RawRequest& request, std::shared_ptr<Unread> unread);
  v1::Status admit(const Unread& unread, v1::Request::CallCase call) const;
  bool othersLeaveRoom(const Unread& unread) const;
  void sendReplies();

  Peer peerOf(const SocketLoop::Message& message) const;

  const std::int64_t unread_bytes_;
  const std::shared_ptr<ClientKeys> clients_;  // null without keys
  RequestCounts& counts_;
  std::shared_ptr<SocketLoop> loop_;
  std::shared_ptr<Outbox> outbox_;
  std::map<std::string, std::shared_ptr<Unread>> unread_;  // by connection; of those who have some
  Handler handler_;
};

}  // namespace saccade
