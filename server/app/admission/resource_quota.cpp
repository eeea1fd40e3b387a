#include "app/admission/resource_quota.h"

#include <algorithm>

namespace saccade {
namespace {

constexpr std::chrono::seconds kBurst{1};  // the amount of a rate that may be taken at once

}  // namespace

std::shared_ptr<void> ResourceQuota::take(const std::string& client, const std::vector<Share>& shares) {
  std::lock_guard lock(mutex_);
  for (const Share& share : shares) {
    const auto own = ofOneClient(share.limit);
    const auto taken = taken_by_.find(client);
    if (own && !client.empty()) check(taken == taken_by_.end() ? Taken{} : taken->second, *own, share);
    check(taken_, share.limit, share);
  }
  add(client, shares, 1);
  return {this, [client, shares](ResourceQuota* quota) {
            std::lock_guard lock(quota->mutex_);
            quota->add(client, shares, -1);
          }};
}

void ResourceQuota::use(Limit rate, double amount) {
  std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  Clock::time_point& paid_off = paid_off_[rate];
  paid_off = std::max(paid_off, now - kBurst);
  const std::chrono::duration<double> left = paid_off - now, added(amount / limits_[rate]);
  if (left.count() > 0) {
    throw LimitReached(rate, {}, "more than " + amountText(rate, limits_[rate]) + " are asked for",
                       left.count());
  }
  paid_off += std::chrono::duration_cast<Clock::duration>(added);
}

double ResourceQuota::taken(Limit limit) const {
  std::lock_guard lock(mutex_);
  const auto found = taken_.find(limit);
  return found == taken_.end() ? 0 : found->second;
}

void ResourceQuota::check(const Taken& taken, Limit limit, const Share& share) const {
  const auto found = taken.find(share.limit);
  const double before = found == taken.end() ? 0 : found->second, most = limits_[limit];
  if (before + share.amount <= most) return;
  const bool others = limit == share.limit && share.amount <= most;
  throw LimitReached(limit, share.field,
                     amountText(limit, share.amount) + " more would exceed " + amountText(limit, most) +
                         ", " + amountText(limit, before) + " are taken",
                     others ? kRetrySeconds : 0);
}

void ResourceQuota::add(const std::string& client, const std::vector<Share>& shares, int sign) {
  for (const Share& share : shares) taken_[share.limit] += sign * share.amount;
  if (client.empty()) return;
  Taken& own = taken_by_[client];
  for (const Share& share : shares) own[share.limit] += sign * share.amount;
  const bool none = std::all_of(own.begin(), own.end(), [](const auto& entry) { return entry.second == 0; });
  if (none) taken_by_.erase(client);
}

}  // namespace saccade
