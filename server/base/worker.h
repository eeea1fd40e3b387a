// A thread that runs tasks one after the other, for callers that must not block.
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
  ~Worker();  // finishes the task that runs, and drops those that wait

  // From any thread. `task` is destroyed on the worker's thread when it is done. Exceptions of a task are
  // ignored: it must report its own. The caller bounds how many tasks wait.
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
