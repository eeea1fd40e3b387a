// The broadcast socket: packets for any number of subscribers, each with its topic before it.
//
// To a SUB socket it is an XPUB; here it is a ROUTER, so that each subscriber has its own subscriptions,
// its own queue and its own end. A stream starts once all its topics have been subscribed, or kJoinTime after
// the first: a subscriber of several sensors shall not miss the beginning of the others. It has a receiver as
// long as anybody subscribes to any of its topics. A subscriber that is too slow loses packets, and holds
// nobody up. A stream with nothing to send for kHeartbeatPause sends a heartbeat on each topic.
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
  static constexpr std::chrono::milliseconds kHeartbeatPause{1000};
  static constexpr std::size_t kMaxTopics = 1024;  // of one subscriber; more are passed over

  // Binds; throws std::runtime_error. Keeps a reference.
  BroadcastServer(const std::string& endpoint, const SessionDirectory& sessions, const Access& access = {});
  ~BroadcastServer() { stop(); }

  std::string endpoint() const { return loop_.endpoint(); }
  WakeFd& wake() { return loop_.wake(); }  // for the sessions it is to serve
  auto lastTurn() const { return loop_.lastTurn(); }
  void start();
  void stop() { loop_.stop(); }

 private:
  struct Subscriber {
    std::string user;              // see SocketLoop::Message
    std::set<std::string> topics;  // of streams that there are, or were
  };
  struct Audience {
    ChangeNotifier::Clock::time_point first;  // since when it is not empty
    ChangeNotifier::Clock::time_point last_sent;
    std::map<std::string, std::set<std::string>> peers;  // by topic, but for topics without
    bool told = false;                                   // the session, that it has a receiver
  };
  void receive(const SocketLoop::Message& message);
  void subscribe(const SocketLoop::Message& message, const std::string& topic);
  void unsubscribe(const std::string& peer, const std::string& topic);
  void forget(const std::string& peer);
  std::chrono::milliseconds turn();
  void forgetRevoked();
  void serve(Session& session, Audience& audience);
  bool complete(const Session& session, const Audience& audience) const;  // as far as is worth waiting for
  void sendPacketsOf(Session& session, Audience& audience);
  void sendTo(const Audience& audience, const std::string& topic, const SocketLoop::Part& header,
              const SocketLoop::Part& payload);

  SocketLoop loop_;
  const SessionDirectory& sessions_;
  std::map<std::string, Subscriber> subscribers_;  // by peer
  std::map<std::string, Audience> audiences_;      // of streams that have ever been subscribed, by id
  std::set<std::string> gone_;                     // peers, noticed while packets were sent
};

}  // namespace saccade
