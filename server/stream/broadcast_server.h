// The broadcast socket: packets for any number of subscribers, each with its topic before it.
//
// A stream starts once all its topics have been subscribed, or kJoinTime after the first: a subscriber of
// several sensors shall not miss the beginning of the others. It has a receiver as long as anybody subscribes
// to any of its topics. Who is too slow loses packets, and holds nobody up. A stream with nothing to send for
// kHeartbeatPause sends a heartbeat on each topic.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "stream/session_directory.h"
#include "stream/socket_loop.h"

namespace saccade {

class BroadcastServer {
 public:
  static constexpr std::chrono::milliseconds kJoinTime{250};
  static constexpr std::chrono::milliseconds kHeartbeatPause{1000};

  // Binds; throws std::runtime_error. Keeps a reference.
  BroadcastServer(const std::string& endpoint, const SessionDirectory& sessions,
                  const std::optional<ServerKeys>& keys = std::nullopt);
  ~BroadcastServer() { stop(); }

  std::string endpoint() const { return loop_.endpoint(); }
  WakeFd& wake() { return loop_.wake(); }  // for the sessions it is to serve
  auto lastTurn() const { return loop_.lastTurn(); }
  void start();
  void stop() { loop_.stop(); }

 private:
  struct Audience {
    Signal::Clock::time_point first;  // since when it is not empty
    Signal::Clock::time_point last_sent;
    std::map<std::string, int> subscribers;  // by topic, but for those without
    bool told = false;                       // the session, that it has a receiver
  };
  void receive(const std::vector<std::string>& parts);
  void unsubscribe(Session& session, const std::string& topic);
  void serve(Session& session, Audience& audience);
  std::chrono::milliseconds turn();
  bool complete(const Session& session, const Audience& audience) const;  // as far as is worth waiting for
  void sendPacketsOf(Session& session, Audience& audience);

  SocketLoop loop_;
  const SessionDirectory& sessions_;
  std::map<std::string, Audience> audiences_;  // of streams that have ever been subscribed, by id
};

}  // namespace saccade
