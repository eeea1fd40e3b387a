#include "base/tile_pool.h"

#include <pmmintrin.h>
#include <xmmintrin.h>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/lower_priority.h"
#include "base/received_share.h"
#include "base/thread_time.h"
#include "base/usable_cpus.h"

namespace saccade {
namespace {

// Of the jobs that this thread has run.
thread_local std::chrono::nanoseconds chain_time{0};

}  // namespace

void flushDenormalsToZero() {
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
}

int hardwareThreads() {
  return static_cast<int>(std::ceil(usableCpus()));
}

struct TilePool::Workers {
  explicit Workers(int count);
  ~Workers();
  void work();

  // Jobs with pieces left to take, in turn.
  struct Open {
    std::vector<Job*> jobs;
    std::size_t turn = 0;  // whose it is
  };
  // The work that a thread is at.
  struct Running {
    Workers* workers = nullptr;
    bool urgent = false;
    std::chrono::nanoseconds let_first{0};  // CPU time of the pieces that went before this one
  };
  static thread_local Running here;
  static bool isUrgent(const Job& job) { return job.priority == Priority::kUrgent; }
  bool idle() const { return urgent.jobs.empty() && others.jobs.empty(); }
  void submit(Job& job);
  std::chrono::nanoseconds runPiece(Open& open, std::unique_lock<std::mutex>& lock);
  void runUrgent();

  std::mutex mutex;
  std::condition_variable wanted;
  Open urgent, others;
  std::atomic<int> urgent_jobs = 0;  // with pieces left
  bool stop = false;
  ReceivedShare share;  // of the time in which the threads had a piece
  std::vector<std::thread> threads;
};

thread_local TilePool::Workers::Running TilePool::Workers::here;

TilePool::Workers::Workers(int count) {
  for (Open* open : {&urgent, &others}) open->jobs.reserve(64);
  for (int i = 0; i < count; ++i) threads.emplace_back([this] { work(); });
}

TilePool::Workers::~Workers() {
  {
    std::lock_guard lock(mutex);
    SACCADE_CHECK(idle());
    stop = true;
  }
  wanted.notify_all();
  for (auto& thread : threads) thread.join();
}

void TilePool::Workers::submit(Job& job) {
  (isUrgent(job) ? urgent : others).jobs.push_back(&job);
  if (isUrgent(job)) ++urgent_jobs;
  wanted.notify_all();
}

// Takes the next piece of `open`, which has one. Its CPU time is without that of the pieces it let go first.
// Returns the time of all of them.
std::chrono::nanoseconds TilePool::Workers::runPiece(Open& open, std::unique_lock<std::mutex>& lock) {
  auto& [jobs, turn] = open;
  if (turn >= jobs.size()) turn = 0;  // behind the last one comes the first
  Job& job = *jobs[turn];
  if (job.stop.stop_requested()) job.count = job.next + 1;  // this one is the last
  const int piece = job.next++;
  if (job.next == job.count) {
    jobs.erase(jobs.begin() + static_cast<std::ptrdiff_t>(turn));  // the next one takes its place
    if (isUrgent(job)) --urgent_jobs;
  } else {
    ++turn;
  }
  ++job.running;
  lock.unlock();
  const Running outer = std::exchange(here, {this, isUrgent(job)});
  const auto start = threadCpuTime();
  std::exception_ptr fault;
  try {
    job.piece(job.context, piece);
  } catch (...) {
    fault = std::current_exception();
  }
  const auto used = threadCpuTime() - start, own = used - here.let_first;
  here = outer;
  here.let_first += used;
  lock.lock();
  job.cpu += own;
  job.longest = std::max(job.longest, own);
  if (fault) job.fault = fault;
  // With the lock: without it the caller might be gone already, and the job with it.
  if (--job.running == 0 && job.next == job.count) job.done.notify_one();
  return used;
}

void TilePool::Workers::runUrgent() {
  std::unique_lock lock(mutex);
  while (!urgent.jobs.empty()) runPiece(urgent, lock);
}

void TilePool::Workers::work() {
  flushDenormalsToZero();
  lowerPriority();
  std::unique_lock lock(mutex);
  while (true) {
    wanted.wait(lock, [&] { return stop || !idle(); });
    if (stop) return;
    const auto began = ReceivedShare::Clock::now();
    const auto used = runPiece(urgent.jobs.empty() ? others : urgent, lock);
    const auto now = ReceivedShare::Clock::now();
    share.add(used, now - began, now);
  }
}

void TilePool::yieldToHighPriority() {
  const auto& here = Workers::here;
  if (here.workers && !here.urgent && here.workers->urgent_jobs > 0) here.workers->runUrgent();
}

TilePool::TilePool(int threads) : workers_(std::make_unique<Workers>(threads)) {
  SACCADE_CHECK(threads >= 1);
}

TilePool::TilePool(CallingThread) : workers_(std::make_unique<Workers>(0)) {}

TilePool::~TilePool() = default;

int TilePool::threads() const {
  return std::max(1, static_cast<int>(workers_->threads.size()));
}

double TilePool::receivedShare() const {
  std::lock_guard lock(workers_->mutex);
  return workers_->share.value();
}

std::chrono::nanoseconds TilePool::criticalPathTime() {
  return chain_time;
}

std::chrono::nanoseconds TilePool::runHere(Job& job) {
  flushDenormalsToZero();
  const auto start = threadCpuTime();
  for (; job.next < job.count && !job.stop.stop_requested(); ++job.next) {
    try {
      job.piece(job.context, job.next);
    } catch (...) {
      job.fault = std::current_exception();
    }
  }
  return threadCpuTime() - start;
}

std::chrono::nanoseconds TilePool::runJob(Job& job) {
  if (job.count == 0) return {};
  if (workers_->threads.empty()) {
    job.cpu = runHere(job);
    chain_time += job.cpu;
    throwIfStopped(job.stop);
    if (job.fault) std::rethrow_exception(job.fault);
    return job.cpu;
  }
  std::unique_lock lock(workers_->mutex);
  workers_->submit(job);
  job.done.wait(lock, [&] { return job.next == job.count && job.running == 0; });
  chain_time += std::max(job.cpu / threads(), job.longest);
  throwIfStopped(job.stop);
  if (job.fault) std::rethrow_exception(job.fault);
  return job.cpu;
}

}  // namespace saccade
