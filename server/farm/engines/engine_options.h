// The options of all engines. An engine is a program of others that starts workers, such as Slurm.
#pragma once

#include <string>
#include <vector>

namespace saccade::farm {

struct EngineOptions {
  std::string program = {};              // saccade-farm, absolute
  std::vector<std::string> render = {};  // further words of `saccade-farm run`, such as "--scenes", "/scenes"
  int cpus = 4;                          // of a task, >= 1
  int memory_mib = 4096;                 // of a task, >= 1
  int parallel = 0;                      // tasks at a time, at most; 0: the engine decides
  int retries = 3;                       // of a task that fails, >= 0
};

// Limits of the numbers above.
inline constexpr int kMostCpus = 1024;
inline constexpr int kMostMemoryMib = 1 << 24;
inline constexpr int kMostRetries = 1000;

}  // namespace saccade::farm
