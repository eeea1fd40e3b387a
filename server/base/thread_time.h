// CPU time of the calling thread, and of the whole process.
#pragma once

#include <chrono>
#include <ctime>

namespace saccade {

inline std::chrono::nanoseconds cpuTimeOf(clockid_t clock) {
  timespec t;
  clock_gettime(clock, &t);
  return std::chrono::seconds(t.tv_sec) + std::chrono::nanoseconds(t.tv_nsec);
}
inline std::chrono::nanoseconds threadCpuTime() {
  return cpuTimeOf(CLOCK_THREAD_CPUTIME_ID);
}
inline std::chrono::nanoseconds processCpuTime() {
  return cpuTimeOf(CLOCK_PROCESS_CPUTIME_ID);
}

}  // namespace saccade
