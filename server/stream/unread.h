// What one peer has asked for and not taken yet.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

#include "stream/request_counts.h"

namespace saccade {

struct Unread {
  std::atomic<int> replies = 0;  // from the request until the kernel has the reply
  std::atomic<std::int64_t> bytes = 0;
};

// One reply of these. Where it is never made, that is counted.
class UnreadReply {
 public:
  UnreadReply(std::shared_ptr<Unread> peer, RequestCounts& counts) : peer_(std::move(peer)), counts_(counts) {
    ++peer_->replies;
  }
  ~UnreadReply() {
    if (bytes_ == 0) counts_.drop();
    --peer_->replies;
    peer_->bytes -= bytes_;
  }
  UnreadReply(const UnreadReply&) = delete;
  UnreadReply& operator=(const UnreadReply&) = delete;

  void setBytes(std::size_t bytes) {  // > 0; once, when the reply is made
    bytes_ = static_cast<std::int64_t>(bytes);
    peer_->bytes += bytes_;
  }

 private:
  const std::shared_ptr<Unread> peer_;
  RequestCounts& counts_;
  std::int64_t bytes_ = 0;
};

}  // namespace saccade
