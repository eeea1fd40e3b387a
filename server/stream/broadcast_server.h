// The broadcast socket: sends packets to any number of subscribers, each behind its topic.
//
// SUB sockets take it for an XPUB. It is a ROUTER, so that each subscriber has its own subscriptions and
// queue. A stream starts once all its topics are subscribed, or kJoinTime after the first. So a subscriber of
// several sensors does not miss the beginning of one. A stream has a receiver while anybody subscribes to any
// of its topics. A slow subscriber loses packets and delays nobody. A stream with nothing to send for
// kHeartbeatPause sends a heartbeat on each topic.
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
  static constexpr std::size_t kMaxTopics = 1024;  // of one subscriber; more are ignored

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
    std::set<std::string> topics;  // of present or past streams
  };
  struct Audience {
    ChangeNotifier::Clock::time_point first;  // when the first subscriber came
    ChangeNotifier::Clock::time_point last_sent;
    std::map<std::string, std::set<std::string>> peers;  // by topic; topics without subscribers are absent
    bool announced = false;                              // whether the session knows of its receiver
  };
  void receive(const SocketLoop::Message& message);
  void subscribe(const SocketLoop::Message& message, const std::string& topic);
  void unsubscribe(const std::string& peer, const std::string& topic);
  void forget(const std::string& peer);
  std::chrono::milliseconds turn();
  void forgetRevoked();
  void serve(Session& session, Audience& audience);
  bool complete(const Session& session, const Audience& audience) const;  // or kJoinTime is over
  void sendPacketsOf(Session& session, Audience& audience);
  void sendTo(const Audience& audience, const std::string& topic, const MessagePart& header,
              const MessagePart& payload);

  SocketLoop loop_;
  const SessionDirectory& sessions_;
  std::map<std::string, Subscriber> subscribers_;  // by peer
  std::map<std::string, Audience> audiences_;      // by id of a stream; absent before the first subscription
  std::set<std::string> gone_;                     // peers whose end was noticed while sending
};

}  // namespace saccade
