// Compares the files of a data set with what its plan and its digests say.
#pragma once

#include <functional>
#include <string>

#include "farm/dataset/data_set.h"

namespace saccade::farm {

struct Verified {
  std::uint64_t sequences = 0, bytes = 0;  // that are as they should be
  std::uint64_t damaged = 0, missing = 0, foreign = 0;
  bool whole() const { return damaged == 0 && missing == 0 && foreign == 0; }
};

// Reads all files. `tell` hears of each fault: what it is, and of which file. `step` hears of each shard.
Verified verify(const DataSet& set, const std::function<void(const std::string&)>& tell,
                const std::function<void(std::uint32_t shard)>& step);

}  // namespace saccade::farm
