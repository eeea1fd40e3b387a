#include "app/process_usage.h"

#include <sys/resource.h>
#include <unistd.h>

#include <ctime>
#include <filesystem>
#include <fstream>

namespace saccade {
namespace {

double residentBytes() {
  std::ifstream statm("/proc/self/statm");
  double total = 0, resident = 0;
  statm >> total >> resident;  // pages
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double openFiles() {
  std::error_code none;
  const std::filesystem::directory_iterator files("/proc/self/fd", none);
  return none ? 0
              : static_cast<double>(std::distance(begin(files), end(files)) - 1);  // without the folder's own
}

}  // namespace

ProcessUsage processUsage() {
  timespec cpu{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &cpu);
  rlimit files{};
  getrlimit(RLIMIT_NOFILE, &files);
  return {static_cast<double>(cpu.tv_sec) + static_cast<double>(cpu.tv_nsec) * 1e-9, residentBytes(),
          openFiles(), static_cast<double>(files.rlim_cur)};
}

}  // namespace saccade
