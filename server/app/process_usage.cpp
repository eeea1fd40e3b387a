#include "app/process_usage.h"

#include <sys/resource.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/thread_time.h"
#include "base/units.h"

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
  rlimit files{};
  getrlimit(RLIMIT_NOFILE, &files);
  return {seconds(processCpuTime()), residentBytes(), openFiles(), static_cast<double>(files.rlim_cur)};
}

}  // namespace saccade
