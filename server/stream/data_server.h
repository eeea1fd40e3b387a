// The data socket: sends each stream's packets to the connection attached to it, while its credit lasts.
//
// A connection that gets no packet for kHeartbeatPause gets a heartbeat, which costs no credit. It tells how
// far the stream is, and lets both ends notice that the other one is gone.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "stream/session_directory.h"
#include "stream/socket_loop.h"

namespace saccade {

class DataServer {
 public:
  static constexpr std::chrono::milliseconds kHeartbeatPause{1000};

  // Binds; throws std::runtime_error. Keeps a reference to `sessions`. `max_credit`: bytes of one connection.
  DataServer(const std::string& endpoint, const SessionDirectory& sessions, std::int64_t max_credit,
             const Access& access = {});
  ~DataServer() { stop(); }

  std::string endpoint() const { return loop_.endpoint(); }
  WakeFd& wake() { return loop_.wake(); }  // for the sessions it is to serve
  auto lastTurn() const { return loop_.lastTurn(); }
  void start();
  void stop() { loop_.stop(); }

 private:
  struct Connection {
    std::shared_ptr<Session> session;
    std::string user;               // its owner, see SocketLoop::Message
    std::int64_t credit_bytes = 0;  // below 0: overdrawn by its last packet
    ChangeNotifier::Clock::time_point last_sent = ChangeNotifier::Clock::now();
  };
  void receive(const SocketLoop::Message& message);
  // Each returns what is wrong, or an empty text.
  std::string handle(const SocketLoop::Message& message, const v1::DataRequest& request);
  std::string attach(const SocketLoop::Message& message, const v1::Attach& request);
  std::string addCredit(Connection& connection, std::uint64_t bytes);
  std::string acknowledge(Connection& connection, const v1::Ack& ack);
  Connection* find(const SocketLoop::Message& message);
  void forget(const std::string& peer);
  void takeOver(const Session& session, const std::string& peer);
  void refuse(const std::string& peer, const std::string& stream_id, const std::string& message);
  std::chrono::milliseconds sendPackets();
  SocketLoop::Sent sendPacketsOf(const std::string& peer, Connection& connection);
  SocketLoop::Sent sendHeartbeat(const std::string& peer, Connection& connection);

  SocketLoop loop_;
  const SessionDirectory& sessions_;
  const std::int64_t max_credit_;
  std::map<std::string, Connection> connections_;  // attached ones, by peer; at most one for a stream
};

}  // namespace saccade
