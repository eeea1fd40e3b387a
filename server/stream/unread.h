// Counts the replies that one peer has asked for and not taken yet.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "stream/request_counts.h"

namespace saccade {

struct Unread {
  const std::string user = {};   // of the peer
  std::atomic<int> replies = 0;  // each from its request until the kernel has it
  std::atomic<std::int64_t> bytes = 0;
};

// One such reply, counted for as long as this object lives. One that is never made counts as dropped.
class UnreadReply {
 public:
  // `expected`: the bytes to count until it is made, or until expect() says more.
  UnreadReply(std::shared_ptr<Unread> peer, std::size_t expected, RequestCounts& counts)
      : peer_(std::move(peer)), counts_(counts) {
    ++peer_->replies;
    count(expected);
  }
  ~UnreadReply() {
    if (!made_) counts_.drop();
    count(0);
    --peer_->replies;
  }
  UnreadReply(const UnreadReply&) = delete;
  UnreadReply& operator=(const UnreadReply&) = delete;

  void expect(std::size_t bytes) {
    count(std::max(bytes, static_cast<std::size_t>(bytes_)));
  }                               // before make()
  void make(std::size_t bytes) {  // once
    made_ = true;
    count(bytes);
  }

 private:
  void count(std::size_t bytes) {
    const auto before = std::exchange(bytes_, static_cast<std::int64_t>(bytes));
    peer_->bytes += bytes_ - before;
  }

  const std::shared_ptr<Unread> peer_;
  RequestCounts& counts_;
  bool made_ = false;
  std::int64_t bytes_ = 0;
};

}  // namespace saccade
