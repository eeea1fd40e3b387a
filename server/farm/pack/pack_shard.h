// The tar files of a shard: one for each split of the data set. It is empty where the shard has no sequence
// of the split, so that names such as train-{00000..00019}.tar are all there.
#pragma once

#include <functional>
#include <stdexcept>

#include "farm/dataset/data_set.h"

namespace saccade::farm {

// A file of the data set is missing, or is not what its digest says. The text names the file.
struct DamagedFile : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct PackCounts {
  std::uint64_t written = 0, found = 0;      // tar files
  std::uint64_t sequences = 0, bytes = 0;    // in those that were written
  std::uint32_t unfinished = 0, faulty = 0;  // shards
  bool stopped = false;
};

std::filesystem::path tarFile(const DataSet& set, std::uint32_t shard, const std::string& split);

// Writes those that are not there yet, and adds to `counts`. A tar file of the right length is there. Where
// `stop` says so, `counts.stopped` is set and no file is left. `step` hears of each sequence. Throws
// DamagedFile, std::runtime_error where the index or a name is wrong, and std::system_error for writing.
void packShard(const DataSet& set, std::uint32_t shard, const std::function<bool()>& stop,
               const std::function<void(const PackCounts&)>& step, PackCounts& counts);

}  // namespace saccade::farm
