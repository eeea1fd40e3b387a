// Makes what is missing of a data set, or of one of its shards.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "farm/dataset/data_set.h"
#include "farm/worker/sequence_renderer.h"

namespace saccade::farm {

struct RunOptions {
  std::optional<std::uint32_t> shard = {};  // unset: all
  int workers = 0;                          // processes; 0: one for each CPU
  int cpus = 0;                             // that they use; 0: cpusGiven()
  RenderSettings render = {};
};

// Of the sequences of this run.
struct RunCounts {
  std::uint64_t all = 0;
  std::uint64_t found = 0, done = 0;   // were there before; are made now
  std::uint64_t retry = 0, never = 0;  // failed: another run may make them, or none can
  double cpu_s = 0;                    // of the workers
};

// The CPUs that the engine gives: those that this process may use, its control group's quota, and
// SLURM_CPUS_PER_TASK; at least 1.
int cpusGiven();

// Runs until all is done or has failed, or `stop()` is true. `tell` hears of the counts as they grow, and of
// each failure. Throws std::runtime_error where nothing can be made.
RunCounts run(const DataSet& set, const RunOptions& options, const std::function<bool()>& stop,
              const std::function<void(const RunCounts&, const std::string& failure)>& tell);

}  // namespace saccade::farm
