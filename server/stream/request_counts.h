// Counts the requests since the server started: answered ones by call and code, and dropped ones.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <utility>

#include "saccade/v1/control.pb.h"

namespace saccade {

class RequestCounts {
 public:
  using Kind = std::pair<v1::Request::CallCase, v1::Code>;

  // From any thread.
  void add(Kind kind) {
    std::lock_guard lock(mutex_);
    ++counts_[kind];
  }
  void drop() { ++dropped_; }
  std::uint64_t dropped() const { return dropped_; }
  std::map<Kind, std::uint64_t> all() const {
    std::lock_guard lock(mutex_);
    return counts_;
  }

 private:
  mutable std::mutex mutex_;
  std::map<Kind, std::uint64_t> counts_;
  std::atomic<std::uint64_t> dropped_ = 0;
};

}  // namespace saccade
