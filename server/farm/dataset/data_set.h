// The folder of a data set. ../README.md shows what is in it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "saccade/v1/dataset.pb.h"

namespace saccade::farm {

class DataSet {
 public:
  using Path = std::filesystem::path;

  // Reads plan.json. Throws std::runtime_error, which says what to do, where the folder is no data set.
  explicit DataSet(const std::string& folder);

  const v1::DataSetPlan& plan() const { return plan_; }
  const Path& folder() const { return folder_; }  // absolute
  Path recipeFolder() const { return folder_ / "recipe"; }
  Path shardFolder(std::uint32_t shard) const { return folder_ / "shards" / shardName(shard); }
  Path sequenceFolder(const v1::DataSetSequence& sequence) const;
  Path indexFile(std::uint32_t shard) const { return shardFolder(shard) / "index.jsonl"; }
  Path failedFolder(std::uint32_t shard) const { return folder_ / "failed" / shardName(shard); }
  Path failedFile(const v1::DataSetSequence& sequence) const;
  Path partialFolder() const { return folder_ / "partial"; }
  Path workersFolder() const { return folder_ / "workers"; }

  // The sequences that the plan gives to a shard, in order, without files. Throws as readJsonLines().
  std::vector<v1::DataSetSequence> planned(std::uint32_t shard) const;
  std::uint32_t shardOf(std::uint64_t number) const;  // of a sequence
  std::uint64_t first(std::uint32_t shard) const;     // sequence; that of the shard after the last: how many
  std::uint64_t shardSize(std::uint32_t shard) const { return first(shard + 1) - first(shard); }

  std::string sequenceName(std::uint64_t number) const;  // of equal length for all of the data set
  std::string shardName(std::uint32_t shard) const;

 private:
  Path folder_;
  v1::DataSetPlan plan_;
};

// Names in the folder of a data set, and of a sequence.
inline constexpr const char* kPlanFile = "plan.json";
inline constexpr const char* kSequenceFile = "sequence.json";
inline constexpr const char* kRecipeFile = "recipe.toml";

// The file of a shard's table.
std::filesystem::path planTable(const std::filesystem::path& folder, const std::string& shard_name);
std::string shardNameOf(std::uint32_t shard, std::uint32_t shards);

}  // namespace saccade::farm
