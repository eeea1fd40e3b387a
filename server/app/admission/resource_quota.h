// The ledger of limited resources: what all streams, and those of each client, hold of them.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/admission/limits.h"

namespace saccade {

struct Share {
  Limit limit;
  double amount;           // in the limit's unit
  std::string field = {};  // of the request that asks for it, for the refusal
};

class ResourceQuota {
 public:
  explicit ResourceQuota(const Limits& limits) : limits_(limits) {}
  const Limits& limits() const { return limits_; }

  // Takes all of the shares or none. They are given back when the last copy of the result goes, which the
  // quota must outlive. `client`: its public key, empty without keys. Throws LimitReached naming the first
  // limit that is too low.
  std::shared_ptr<void> take(const std::string& client, const std::vector<Share>& shares);

  // Takes an amount of a limit that is a rate. So much as a second brings may be taken at once. Throws
  // LimitReached until the time that earlier amounts take beyond that is over. A single amount may exceed the
  // limit.
  void use(Limit rate, double amount);

  // The amount that all clients together hold, in the limit's unit.
  double taken(Limit limit) const;

 private:
  using Clock = std::chrono::steady_clock;
  using Taken = std::map<Limit, double>;
  void check(const Taken& taken, Limit limit, const Share& share) const;
  void add(const std::string& client, const std::vector<Share>& shares, int sign);

  const Limits limits_;
  mutable std::mutex mutex_;
  Taken taken_;
  std::map<std::string, Taken> taken_by_;        // by client
  std::map<Limit, Clock::time_point> paid_off_;  // by rate: when the amounts so far are paid off
};

}  // namespace saccade
