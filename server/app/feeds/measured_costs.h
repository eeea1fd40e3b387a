// The costs of frames that were measured lately. Streams of equal frames that open soon afterwards have the
// same.
#pragma once

#include <chrono>
#include <deque>
#include <mutex>
#include <optional>
#include <string>

#include "app/feeds/pace.h"

namespace saccade {

// All members may be called from any thread.
class MeasuredCosts {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kFresh{60};  // older ones are forgotten
  static constexpr std::size_t kMost = 64;           // likewise the oldest of more
  static constexpr std::size_t kMostKey = 4096;      // bytes; the cost of a longer key is not kept

  // `key`: ResolvedStream::costKey().
  std::optional<CpuCost> find(const std::string& key, Clock::time_point now);
  void add(const std::string& key, const CpuCost& cost, Clock::time_point now);

 private:
  struct Entry {
    std::string key;
    CpuCost cost;
    Clock::time_point at;
  };
  std::mutex mutex_;
  std::deque<Entry> entries_;  // the oldest first
};

}  // namespace saccade
