// The broadcast socket: packets for any number of subscribers, each with its topic before it.
//
// A stream starts once all its topics have been subscribed, or kJoinTime after the first: a subscriber of
// several sensors shall not miss the beginning of the others.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>

#include "stream/session_directory.h"
#include "stream/socket_loop.h"

namespace saccade {

class BroadcastServer {
 public:
  static constexpr std::chrono::milliseconds kJoinTime{250};

  // Binds; throws std::runtime_error. Keeps a reference.
  BroadcastServer(const std::string& endpoint, const SessionDirectory& sessions,
                  const std::optional<ServerKeys>& keys = std::nullopt);

  std::string endpoint() const { return loop_.endpoint(); }
  WakeFd& wake() { return loop_.wake(); }  // for the sessions it is to serve
  auto lastTurn() const { return loop_.lastTurn(); }
  void start();
  void stop() { loop_.stop(); }

 private:
  struct Joining {
    Signal::Clock::time_point deadline;
    std::set<std::string> topics;
  };
  void receive(const std::vector<std::string>& parts);
  std::chrono::milliseconds turn();
  bool ready(const Session& session) const;  // enough of its topics are subscribed
  void sendPacketsOf(Session& session);

  SocketLoop loop_;
  const SessionDirectory& sessions_;
  std::map<std::string, Joining> joining_;  // streams that have not started, by id
};

}  // namespace saccade
