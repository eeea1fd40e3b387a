// Resources that this process uses.
#pragma once

namespace saccade {

struct ProcessUsage {
  double cpu_s;  // user and system, of all threads
  double resident_bytes;
  double open_fds, max_fds;
};

// A value is 0 where the system does not tell it.
ProcessUsage processUsage();

}  // namespace saccade
