// The number of CPUs that this process may use.
#pragma once

#include <string>

namespace saccade {

// The CPUs that it may run on. If it is less, the CPU quota of its control groups (version 2 or 1) and their
// parents. > 0, may be a fraction.
double usableCpus();

// The least CPU quota of some control groups; infinite where there is none. `memberships`: their names, as in
// /proc/self/cgroup. `root`: the folder where they are mounted.
double cgroupQuota(const std::string& memberships, const std::string& root);

}  // namespace saccade
