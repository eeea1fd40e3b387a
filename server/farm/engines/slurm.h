// A batch script for Slurm: an array with a task for each shard.
#pragma once

#include <string>

#include "farm/dataset/data_set.h"
#include "farm/engines/engine_options.h"

namespace saccade::farm {

struct SlurmOptions {
  EngineOptions engine = {};
  std::string time = {};  // of a task, as sbatch takes it, such as "2:00:00"; empty: the partition's
  int warning_s = 60;     // [1, 65535], before the time is up
  int tasks = 0;          // of the array; 0: one for each shard
};

// Slurm refuses indices of arrays from MaxArraySize on, which is this unless the site sets it.
inline constexpr std::uint32_t kUsualMaxArraySize = 1001;

std::uint32_t slurmTasks(const DataSet& set, const SlurmOptions& options);
// Throws std::invalid_argument where the time is none.
std::string slurmScript(const DataSet& set, const SlurmOptions& options);

}  // namespace saccade::farm
