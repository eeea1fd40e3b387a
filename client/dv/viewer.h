// One connection of DV or dv-processing, and the packets that it has not read yet.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>

#include "client/dv/listener.h"

namespace saccade::client::dv {

// Bytes that several viewers share.
struct Message {
  std::string bytes;
  std::uint64_t events = 0;
};

class Viewer {
 public:
  // `backlog`: bytes that it may leave unread.
  Viewer(Connection connection, std::size_t backlog)
      : connection_(std::move(connection)), backlog_(backlog) {}

  void send(const std::shared_ptr<const Message>& message);
  void write();  // as much as the socket takes now
  void cut() { state_ = State::kTooSlow; }
  void read();  // what it sends means nothing; finds that it has left

  bool pending() const { return !unsent_.empty(); }
  bool gone() const { return state_ != State::kWatching; }
  std::string farewell() const;  // of a viewer that is gone: who, why, and how much it got
  int descriptor() const { return connection_.socket.number(); }
  const std::string& peer() const { return connection_.peer; }

 private:
  enum class State { kWatching, kLeft, kTooSlow };

  Connection connection_;
  std::size_t backlog_;
  State state_ = State::kWatching;
  std::deque<std::shared_ptr<const Message>> unsent_;
  std::size_t unsent_bytes_ = 0, begun_ = 0;  // begun_: sent bytes of the first message
  std::uint64_t sent_events_ = 0, unsent_events_ = 0;
};

}  // namespace saccade::client::dv
