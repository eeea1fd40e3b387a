// What this process takes from the machine.
#pragma once

namespace saccade {

struct ProcessUsage {
  double cpu_s;  // user and system, of all threads
  double resident_bytes;
  double open_fds, max_fds;
};

// 0 where the machine does not tell.
ProcessUsage processUsage();

}  // namespace saccade
