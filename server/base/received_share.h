// The share of a CPU that busy threads get: below 1 where other programs compete for the machine.
#pragma once

#include <chrono>
#include <cmath>

namespace saccade {

// Older measurements fade, by a factor e each kSpan of wall-clock time.
class ReceivedShare {
 public:
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;

  // Adds that a thread was busy for `wall` until `now`, and got `cpu` of CPU time.
  void add(Seconds cpu, Seconds wall, Clock::time_point now) {
    const double kept = std::exp(-(Seconds(now - last_) / kSpan));
    cpu_ = cpu_ * kept + cpu;
    wall_ = wall_ * kept + wall;
    last_ = now;
  }

  // In (0, 1]; 1 before anything is known.
  double value() const { return std::fmin(1, (cpu_ + kUnknown) / (wall_ + kUnknown)); }

 private:
  static constexpr Seconds kSpan{2};
  static constexpr Seconds kUnknown{0.02};  // counts as received whole: a short delay says little

  Seconds cpu_{0}, wall_{0};
  Clock::time_point last_{};
};

}  // namespace saccade
