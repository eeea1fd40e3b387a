// Loaded before the C library: a wall clock that is as many seconds off as the file named by
// SACCADE_TEST_CLOCK says. A test writes to that file while the program runs. The steady clocks are left
// alone.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <ctime>

namespace {

std::int64_t offsetSeconds() {
  static const auto* const offset = [] {
    const int file = open(std::getenv("SACCADE_TEST_CLOCK"), O_RDONLY | O_CLOEXEC);
    void* page = mmap(nullptr, sizeof(std::int64_t), PROT_READ, MAP_SHARED, file, 0);
    close(file);
    return static_cast<const std::atomic<std::int64_t>*>(page);
  }();
  return *offset;
}

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" int clock_gettime(clockid_t clock, timespec* now) noexcept {
  static const auto next = real<int(clockid_t, timespec*)>("clock_gettime");
  const int result = next(clock, now);
  if (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE) now->tv_sec += offsetSeconds();
  return result;
}

extern "C" int gettimeofday(timeval* now, void* zone) noexcept {
  static const auto next = real<int(timeval*, void*)>("gettimeofday");
  const int result = next(now, zone);
  now->tv_sec += offsetSeconds();
  return result;
}

extern "C" time_t time(time_t* now) noexcept {
  static const auto next = real<time_t(time_t*)>("time");
  const time_t shifted = next(nullptr) + offsetSeconds();
  if (now) *now = shifted;
  return shifted;
}
