#include "farm/report/status.h"

#include <dirent.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>

#include "farm/dataset/json_file.h"
#include "farm/worker/worker_file.h"

namespace saccade::farm {
namespace {

namespace fs = std::filesystem;

// The sequences of a shard that is not complete. Readdir alone: millions of names are counted within a
// second.
std::uint64_t countSequences(const fs::path& folder) {
  const std::unique_ptr<DIR, int (*)(DIR*)> names(opendir(folder.c_str()), closedir);
  std::uint64_t count = 0;
  while (const dirent* entry = names ? readdir(names.get()) : nullptr)
    count += std::string_view(entry->d_name).find_first_not_of("0123456789") == std::string_view::npos;
  return count;
}

void addFailures(const DataSet& set, std::uint32_t shard, Status& status) {
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(set.failedFolder(shard), none)) {
    if (entry.path().extension() != ".json") continue;  // it is being written
    try {
      const auto failure = readJson<v1::FailedSequence>(entry.path());
      ++(failure.retry() ? status.retry : status.never);
    } catch (const std::system_error&) {
      // A worker has made it meanwhile.
    }
  }
}

}  // namespace

Status statusOf(const DataSet& set) {
  Status status{.all = set.plan().sequences()};
  for (std::uint32_t shard = 0; shard < set.plan().shards(); ++shard) {
    const std::uint64_t never = status.never;
    addFailures(set, shard, status);
    const bool complete = fs::exists(set.indexFile(shard));
    status.done +=
        complete ? set.shardSize(shard) - (status.never - never) : countSequences(set.shardFolder(shard));
  }
  for (const v1::FarmWorker& worker : liveWorkers(set)) {
    ++status.workers;
    status.running += worker.running();
    const auto ran_s =
        static_cast<double>(std::max<std::int64_t>(1, worker.last_unix_s() - worker.begun_unix_s()));
    status.per_s += static_cast<double>(worker.done()) / ran_s;
  }
  const std::uint64_t left = status.all - std::min(status.all, status.done + status.never);
  if (status.per_s > 0) status.left_s = static_cast<double>(left) / status.per_s;
  return status;
}

}  // namespace saccade::farm
