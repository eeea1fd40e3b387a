// A Snakefile: a job for each shard, whose target is the shard's index.
#pragma once

#include <string>

#include "farm/dataset/data_set.h"
#include "farm/engines/engine_options.h"

namespace saccade::farm {

// Throws std::invalid_argument where the name of the folder cannot stand in a Snakefile.
std::string snakefile(const DataSet& set, const EngineOptions& options);

}  // namespace saccade::farm
