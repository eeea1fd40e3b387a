// A thread that does one thing after the other, for a thread that must not wait.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <queue>
#include <thread>

namespace saccade {

class Worker {
 public:
  Worker();
  ~Worker();  // ends what it is at; what still waits is not done

  // From any thread. `task` is destroyed on the worker's thread once it is done. What it throws is not told:
  // that is the task's to do. How many wait is the caller's to bound.
  void post(std::function<void()> task);

 private:
  void run();

  std::mutex mutex_;
  std::condition_variable wanted_;
  std::queue<std::function<void()>> tasks_;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace saccade
