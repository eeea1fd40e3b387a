// A pool of threads that works through the pieces of jobs. pool_handle.h divides a picture into pieces.
//
// Any number of threads may run jobs at once; each waits for its own job. The workers take pieces from the
// open jobs in turn, so that two feeds share the cores fairly. Pieces of urgent jobs go first. A long piece
// of another job lets them in where it calls yieldToHighPriority(). A piece must write the same values on any
// worker. Then results are the same for any number of threads. All workers flush denormals to zero, because
// the filter is twice as slow without.
#pragma once

#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <stop_token>

#include "base/cancelled.h"

namespace saccade {

// Makes denormals zero, in and out, for the calling thread.
void flushDenormalsToZero();

int hardwareThreads();  // how many threads of this process may run at once

enum class Priority {
  kNormal,
  kUrgent,  // for jobs that must be done by a certain time
};

// In place of a number of threads: jobs run on the thread that asks for them. It is for programs with one
// thread of work, which so save the way to a worker and back.
struct CallingThread {};

// Owns the workers.
class TilePool {
 public:
  explicit TilePool(int threads);  // >= 1
  explicit TilePool(CallingThread);
  ~TilePool();  // no job may be open
  TilePool(const TilePool&) = delete;
  TilePool& operator=(const TilePool&) = delete;

  int threads() const;  // at least 1
  // The share of a CPU's time that a worker with a piece got recently: (0, 1], 1 on an idle machine.
  double receivedShare() const;

  // How long the jobs of the calling thread would have taken so far, each with all workers to itself. A job
  // takes at least as long as its longest piece.
  static std::chrono::nanoseconds criticalPathTime();

  // Lets the worker do all open urgent pieces first, unless its own piece is urgent. Call it between the
  // steps of a piece that may take longer than a few milliseconds. The caller must not hold a lock.
  static void yieldToHighPriority();

 private:
  friend class PoolHandle;
  struct Job {
    int count;
    Priority priority;
    const std::stop_token& stop;
    const void* context;
    void (*piece)(const void*, int);
    int next = 0;                                 // first piece not yet taken
    int running = 0;                              // pieces taken and not finished
    std::chrono::nanoseconds cpu{0}, longest{0};  // of all pieces, of one
    std::exception_ptr fault{};
    std::condition_variable done{};  // one for each job: the end of a job wakes its own caller alone
  };
  struct Workers;

  std::chrono::nanoseconds runJob(Job& job);
  static std::chrono::nanoseconds runHere(Job& job);

  const std::unique_ptr<Workers> workers_;
};

}  // namespace saccade
