#include "base/usable_cpus.h"

#include <sched.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

namespace saccade {
namespace {

constexpr double kNoQuota = std::numeric_limits<double>::infinity();

std::string textOf(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Of numbers in microseconds; "max" and -1 are none.
double quotaOf(const std::string& quota_and_period) {
  std::istringstream text(quota_and_period);
  double quota = 0, period = 0;
  return text >> quota >> period && quota > 0 && period > 0 ? quota / period : kNoQuota;
}

double quotaOfGroup(const std::string& folder) {
  return std::min(quotaOf(textOf(folder + "/cpu.max")), quotaOf(textOf(folder + "/cpu.cfs_quota_us") + " " +
                                                                textOf(folder + "/cpu.cfs_period_us")));
}

// Of the group and its parents.
double quotaOfBranch(const std::string& root, std::string group) {
  double least = quotaOfGroup(root);
  while (!group.empty()) {
    least = std::min(least, quotaOfGroup(root + group));
    group.erase(group.find_last_of('/') == std::string::npos ? 0 : group.find_last_of('/'));
  }
  return least;
}

double allowedCpus() {
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) != 0) return kNoQuota;  // more CPUs than the set holds
  return std::max(1, CPU_COUNT(&set));
}

}  // namespace

// A line is "0::/path" of version 2, or "4:cpu,cpuacct:/path" of version 1.
double cgroupQuota(const std::string& memberships, const std::string& root) {
  double least = kNoQuota;
  std::istringstream lines(memberships);
  for (std::string line; std::getline(lines, line);) {
    const auto first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    if (!controllers.empty() && ("," + controllers + ",").find(",cpu,") == std::string::npos) continue;
    const std::string mount = controllers.empty() ? root : root + "/" + controllers;
    least = std::min(least, quotaOfBranch(mount, line.substr(second + 1)));
  }
  return least;
}

double usableCpus() {
  return std::min(allowedCpus(), cgroupQuota(textOf("/proc/self/cgroup"), "/sys/fs/cgroup"));
}

}  // namespace saccade
