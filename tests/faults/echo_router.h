// The loop that all sockets have, for peers that speak ZMTP by hand.
#pragma once

#include <condition_variable>
#include <mutex>
#include <set>
#include <string>

#include "mock/mock_client.h"
#include "stream/socket_loop.h"

namespace saccade {

inline constexpr std::chrono::seconds kBeforeHeartbeats{
    4};  // miss the answers of these peers, which give none

// A router that notes who speaks and who goes, and answers each message with the same.
class EchoRouter {
 public:
  explicit EchoRouter(const Access& access = {}, std::int64_t max_part_bytes = 64 << 10)
      : loop_({.endpoint = "tcp://127.0.0.1:*", .max_part_bytes = max_part_bytes, .access = access}) {
    loop_.start([this](SocketLoop::Message&& m) { take(m); }, [] { return SocketLoop::kUntilWoken; },
                [this](const std::string& peer) { note(gone_, peer); });
  }
  ~EchoRouter() { loop_.stop(); }

  const std::string& endpoint() const { return loop_.endpoint(); }
  bool heard(std::size_t peers) { return waitFor(heard_, peers); }
  bool gone(std::size_t peers) { return waitFor(gone_, peers); }
  std::set<std::string> names() {
    std::lock_guard lock(mutex_);
    return heard_;
  }

 private:
  void take(const SocketLoop::Message& message) {
    note(heard_, message.peer);
    loop_.send(message.peer, {message.parts[0]});
  }
  void note(std::set<std::string>& peers, const std::string& peer) {
    std::lock_guard lock(mutex_);
    peers.insert(peer);
    changed_.notify_all();
  }
  bool waitFor(const std::set<std::string>& peers, std::size_t count) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, kPatience, [&] { return peers.size() >= count; });
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::set<std::string> heard_, gone_;
  SocketLoop loop_;
};

}  // namespace saccade
