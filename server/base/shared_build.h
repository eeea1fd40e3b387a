// Values that take long to build and that several threads want at once. Each is built once, on a thread of
// its own, while they wait. A build for which nobody waits any more is asked to stop.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

#include "base/cancelled.h"
#include "base/lower_priority.h"

namespace saccade {

// Given to a build.
struct BuildContext {
  std::stop_token stop;                     // once requested, the build should throw Cancelled
  std::function<void(double)> setProgress;  // share that is done, 0 to 1
};

// Keeps no value: a build first looks where its values are kept. All members may be called from any thread.
// Key has an order. Nobody may wait when it is destroyed.
template <class Key, class Value>
class SharedBuild {
 public:
  using Result = std::shared_ptr<const Value>;
  using Build = std::function<Result(const BuildContext&)>;
  using Progress = std::function<void(double)>;

  static constexpr std::size_t kMostBuilds = 8;  // at once, with those that are being stopped; others wait

  SharedBuild() = default;
  SharedBuild(const SharedBuild&) = delete;
  SharedBuild& operator=(const SharedBuild&) = delete;
  // Stops the builds, and waits for them.
  ~SharedBuild() {
    std::unique_lock lock(mutex_);
    for (const auto& [key, running] : running_) running.job->stop.request_stop();
    changed_.wait(lock, [&] { return running_.empty(); });
  }

  // Joins the build of `key`, or starts `build`. Calls `progress` on this thread; it must not throw. Throws
  // what the build throws, and Cancelled as soon as `stop` is requested.
  Result get(const Key& key, const std::stop_token& stop, Build build, const Progress& progress = {}) {
    std::unique_lock lock(mutex_);
    const std::shared_ptr<Job> job = join(lock, key, stop, std::move(build));
    follow(lock, *job, stop, progress);
    const bool last = --job->waiting == 0;
    if (last) job->stop.request_stop();
    throwIfStopped(stop);
    if (job->fault) std::rethrow_exception(last ? std::move(job->fault) : job->fault);
    return last ? std::move(job->result) : job->result;
  }

 private:
  struct Job {
    int waiting = 0;
    bool ended = false;
    double progress = 0;
    Result result = {};
    std::exception_ptr fault = {};
    std::stop_source stop = {};
  };
  struct Running {
    std::shared_ptr<Job> job = std::make_shared<Job>();
    std::jthread thread = {};
  };

  std::shared_ptr<Job> join(std::unique_lock<std::mutex>& lock, const Key& key, const std::stop_token& stop,
                            Build build) {
    const auto may_join = [&] {
      const auto found = running_.find(key);
      return found == running_.end() ? running_.size() < kMostBuilds
                                     : !found->second.job->stop.stop_requested();
    };
    if (!changed_.wait(lock, stop, may_join)) throw Cancelled();
    ended_.clear();
    const auto [entry, is_new] = running_.try_emplace(key);
    if (is_new) start(entry, std::move(build));
    ++entry->second.job->waiting;
    return entry->second.job;
  }

  void start(const typename std::map<Key, Running>::iterator& entry, Build build) {
    try {
      entry->second.thread =
          std::jthread([this, key = entry->first, job = entry->second.job,
                        build = std::move(build)]() mutable { run(key, *job, std::move(build)); });
    } catch (...) {  // the system has no thread
      running_.erase(entry);
      throw;
    }
  }

  // Waits for the end of the build, or for the stop.
  void follow(std::unique_lock<std::mutex>& lock, const Job& job, const std::stop_token& stop,
              const Progress& progress) {
    double told = 0;
    bool ended = false;
    while (!ended && changed_.wait(lock, stop, [&] { return job.ended || job.progress != told; })) {
      ended = job.ended;
      if (job.progress == told) continue;
      told = job.progress;
      lock.unlock();
      if (progress) progress(told);
      lock.lock();
    }
  }

  void run(const Key& key, Job& job, Build build) {
    lowerPriority();
    const auto setProgress = [&](double share) {
      std::lock_guard lock(mutex_);
      job.progress = share;
      changed_.notify_all();
    };
    Result result;
    std::exception_ptr fault;
    try {
      result = build({job.stop.get_token(), setProgress});
    } catch (...) {
      fault = std::current_exception();
    }
    build = {};  // what it holds must not outlast the wait
    std::lock_guard lock(mutex_);
    job.result = std::move(result), job.fault = std::move(fault), job.ended = true;
    const auto mine = running_.find(key);
    ended_.push_back(std::move(mine->second.thread));
    running_.erase(mine);
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::map<Key, Running> running_;
  std::vector<std::jthread> ended_;  // whose threads are about to end
};

}  // namespace saccade
