#include "app/feeds/measured_costs.h"

#include <algorithm>

namespace saccade {

std::optional<CpuCost> MeasuredCosts::find(const std::string& key, Clock::time_point now) {
  std::lock_guard lock(mutex_);
  std::erase_if(entries_, [&](const Entry& entry) { return now - entry.at > kFresh; });
  const auto found = std::ranges::find(entries_, key, &Entry::key);
  if (found == entries_.end()) return {};
  return found->cost;
}

void MeasuredCosts::add(const std::string& key, const CpuCost& cost, Clock::time_point now) {
  if (key.size() > kMostKey) return;
  std::lock_guard lock(mutex_);
  if (entries_.size() == kMost) entries_.pop_front();
  entries_.push_back({key, cost, now});
}

}  // namespace saccade
