// CPU time of the calling thread.
#pragma once

#include <chrono>
#include <ctime>

namespace saccade {

inline std::chrono::nanoseconds threadCpuTime() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return std::chrono::seconds(t.tv_sec) + std::chrono::nanoseconds(t.tv_nsec);
}

}  // namespace saccade
