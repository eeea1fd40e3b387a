// A condition variable whose condition lies outside: raise() wakes threads that wait for it.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace saccade {

class ChangeNotifier {
 public:
  using Clock = std::chrono::steady_clock;

  // Call after the change.
  void raise() {
    { std::lock_guard lock(mutex_); }  // a waiter has either seen the change or is asleep by now
    changed_.notify_all();
  }

  // Sleeps until `ready()`, which is called under the notifier's lock and must not raise this notifier.
  template <class Ready>
  void wait(Ready ready) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, ready);
  }

  // The same, at most until `deadline`. Returns the last answer of `ready()`.
  template <class Ready>
  bool waitUntil(Clock::time_point deadline, Ready ready) {
    std::unique_lock lock(mutex_);
    return changed_.wait_until(lock, deadline, ready);
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
};

}  // namespace saccade
