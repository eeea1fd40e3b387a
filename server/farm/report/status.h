// How far a data set is.
#pragma once

#include "farm/dataset/data_set.h"

namespace saccade::farm {

struct Status {
  std::uint64_t all = 0, done = 0;
  std::uint64_t retry = 0, never = 0;  // failed: another run may make them, or none can
  std::uint64_t running = 0;           // sequences that workers are at
  std::size_t workers = 0;             // runs that go on now
  double per_s = 0;                    // sequences, of those runs
  double left_s = 0;                   // until all is done at this rate; 0: nothing runs
};

// Reads a file for each shard that is complete, and the names in the folders of the others.
Status statusOf(const DataSet& set);

}  // namespace saccade::farm
