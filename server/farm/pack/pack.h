// Tar files for WebDataset: webdataset/SPLIT-SHARD.tar of all shards that are complete.
#pragma once

#include <functional>
#include <string>

#include "farm/pack/pack_shard.h"

namespace saccade::farm {

// `tell` hears of each damaged file, whose shard is left out; `step` of each sequence. `stop`: whether to end
// early. Throws std::system_error where a tar file cannot be written.
PackCounts pack(const DataSet& set, const std::function<bool()>& stop,
                const std::function<void(const std::string&)>& tell,
                const std::function<void(const PackCounts&)>& step);

}  // namespace saccade::farm
