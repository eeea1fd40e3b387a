// How many CPUs this process may use.
#pragma once

#include <string>

namespace saccade {

// The least of the CPUs that it may run on and of the quotas of its control groups, of version 2 or 1, and
// their parents. May be a fraction; > 0.
double usableCpus();

// The least quota of the groups that `memberships`, a text as of /proc/self/cgroup, names below `root`;
// infinite where there is none.
double cgroupQuota(const std::string& memberships, const std::string& root);

}  // namespace saccade
