// What all streams together, and those of each client, may take of the machine.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/admission/limits.h"

namespace saccade {

// So much of a limit, for the sake of a field.
struct Share {
  Limit limit;
  double amount;
  std::string field = {};
};

class ResourceQuota {
 public:
  explicit ResourceQuota(const Limits& limits) : limits_(limits) {}
  const Limits& limits() const { return limits_; }

  // All of the shares, or none; given back when the last copy goes. The budget must outlive it. `client`: its
  // public key, empty without keys. Throws Refusal naming the first limit that is too low.
  std::shared_ptr<void> take(const std::string& client, const std::vector<Share>& shares);

  // So much of a limit that is a rate. Throws LimitReached until what was used before is paid off: one amount
  // may exceed the limit.
  void use(Limit rate, double amount);

 private:
  using Clock = std::chrono::steady_clock;
  using Taken = std::map<Limit, double>;
  void check(const Taken& taken, Limit limit, const Share& share) const;
  void add(const std::string& client, const std::vector<Share>& shares, int sign);

  const Limits limits_;
  std::mutex mutex_;
  Taken taken_;
  std::map<std::string, Taken> taken_by_;        // by client
  std::map<Limit, Clock::time_point> paid_off_;  // of rates
};

}  // namespace saccade
