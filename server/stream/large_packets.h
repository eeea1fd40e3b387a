// The large packets of a stream that its receivers have not taken. A slow receiver holds one more than may
// wait for it, however large it is, and each of them may hold another one. So their number is bounded.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <string>

#include "base/queue_bounds.h"

namespace saccade {

class LargePackets {
 public:
  // The payload, counted for as long as somebody holds what is returned. Null where too many are. From one
  // thread.
  std::shared_ptr<const std::string> lend(const std::shared_ptr<const std::string>& payload) {
    if (payload->size() <= kLargePacket) return payload;
    if (*lent_ >= kMostLargePackets) return nullptr;
    ++*lent_;
    return {payload.get(), [payload, lent = lent_](const std::string*) { --*lent; }};
  }

 private:
  const std::shared_ptr<std::atomic<int>> lent_ = std::make_shared<std::atomic<int>>(0);
};

}  // namespace saccade
