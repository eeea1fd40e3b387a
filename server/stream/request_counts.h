// Requests that were answered since the server started, by call and code.
#pragma once

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
  std::map<Kind, std::uint64_t> all() const {
    std::lock_guard lock(mutex_);
    return counts_;
  }

 private:
  mutable std::mutex mutex_;
  std::map<Kind, std::uint64_t> counts_;
};

}  // namespace saccade
