#include "base/worker.h"

#include <exception>

#include "base/lower_priority.h"

namespace saccade {

Worker::Worker() : thread_([this] { run(); }) {}

Worker::~Worker() {
  {
    std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wanted_.notify_one();
  thread_.join();
}

void Worker::post(std::function<void()> task) {
  {
    std::lock_guard lock(mutex_);
    tasks_.push(std::move(task));
  }
  wanted_.notify_one();
}

void Worker::run() {
  lowerPriority();
  std::unique_lock lock(mutex_);
  while (true) {
    wanted_.wait(lock, [&] { return stop_ || !tasks_.empty(); });
    if (stop_) return;
    auto task = std::move(tasks_.front());
    tasks_.pop();
    lock.unlock();
    try {
      task();
    } catch (const std::exception&) {
    }
    task = nullptr;
    lock.lock();
  }
}

}  // namespace saccade
