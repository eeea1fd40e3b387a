#include "farm/pack/pack.h"

#include <filesystem>
#include <system_error>

#include "farm/pack/new_tar.h"

namespace saccade::farm {

PackCounts pack(const DataSet& set, const std::function<bool()>& stop,
                const std::function<void(const std::string&)>& tell,
                const std::function<void(const PackCounts&)>& step) {
  const std::filesystem::path folder = tarFile(set, 0, "").parent_path();
  std::filesystem::create_directories(folder);
  removePartialTars(folder);
  PackCounts counts;
  for (std::uint32_t shard = 0; shard < set.plan().shards() && !counts.stopped; ++shard) {
    if (!std::filesystem::exists(set.indexFile(shard))) {
      ++counts.unfinished;
      continue;
    }
    try {
      packShard(set, shard, stop, step, counts);
    } catch (const std::system_error&) {
      throw;  // the disk is full, for example
    } catch (const std::runtime_error& fault) {
      ++counts.faulty;
      tell("shard " + set.shardName(shard) + " is not packed: " + fault.what());
    }
  }
  return counts;
}

}  // namespace saccade::farm
