#include "base/tile_pool.h"

#include <pmmintrin.h>
#include <xmmintrin.h>
#include <ctime>

#include "base/check.h"

namespace saccade {
namespace {

std::chrono::nanoseconds threadCpuTime() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return std::chrono::seconds(t.tv_sec) + std::chrono::nanoseconds(t.tv_nsec);
}

}  // namespace

void flushDenormalsToZero() {
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
}

int hardwareThreads() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

TilePool::TilePool(int threads) {
  SACCADE_CHECK(threads >= 1);
  jobs_.reserve(64);
  for (int i = 0; i < threads; ++i) workers_.emplace_back([this] { work(); });
}

TilePool::~TilePool() {
  {
    std::lock_guard lock(mutex_);
    SACCADE_CHECK(jobs_.empty());
    stop_ = true;
  }
  work_.notify_all();
  for (auto& worker : workers_) worker.join();
}

std::chrono::nanoseconds TilePool::runJob(Job& job) {
  if (job.count == 0) return {};
  std::unique_lock lock(mutex_);
  jobs_.push_back(&job);
  work_.notify_all();
  done_.wait(lock, [&] { return job.next == job.count && job.running == 0; });
  if (job.fault) std::rethrow_exception(job.fault);
  return job.cpu;
}

void TilePool::work() {
  flushDenormalsToZero();
  std::unique_lock lock(mutex_);
  while (true) {
    work_.wait(lock, [&] { return stop_ || !jobs_.empty(); });
    if (stop_) return;
    // Take one piece from the next open job in turn.
    turn_ = (turn_ + 1) % jobs_.size();
    Job& job = *jobs_[turn_];
    const int piece = job.next++;
    if (job.next == job.count) jobs_.erase(jobs_.begin() + static_cast<std::ptrdiff_t>(turn_));
    ++job.running;
    lock.unlock();
    const auto start = threadCpuTime();
    std::exception_ptr fault;
    try {
      job.piece(job.context, piece);
    } catch (...) {
      fault = std::current_exception();
    }
    const auto used = threadCpuTime() - start;
    lock.lock();
    job.cpu += used;
    if (fault) job.fault = fault;
    if (--job.running == 0 && job.next == job.count) done_.notify_all();
  }
}

}  // namespace saccade
