// What one peer has asked for and not taken yet.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

namespace saccade {

struct Unread {
  std::atomic<int> replies = 0;  // from the request until the kernel has the reply
  std::atomic<std::int64_t> bytes = 0;
};

// One reply of these.
class UnreadReply {
 public:
  explicit UnreadReply(std::shared_ptr<Unread> peer) : peer_(std::move(peer)) { ++peer_->replies; }
  ~UnreadReply() {
    --peer_->replies;
    peer_->bytes -= bytes_;
  }
  UnreadReply(const UnreadReply&) = delete;
  UnreadReply& operator=(const UnreadReply&) = delete;

  void setBytes(std::size_t bytes) {  // when the reply is made; not from two threads
    const auto before = std::exchange(bytes_, static_cast<std::int64_t>(bytes));
    peer_->bytes += bytes_ - before;
  }

 private:
  const std::shared_ptr<Unread> peer_;
  std::int64_t bytes_ = 0;
};

}  // namespace saccade
