#include "farm/dataset/data_set.h"

#include <algorithm>
#include <stdexcept>

#include "farm/dataset/json_file.h"
#include "farm/recipe/expand.h"

namespace saccade::farm {
namespace {

constexpr std::size_t kShardDigits = 5, kSequenceDigits = 6;  // at least

std::string padded(std::uint64_t number, std::uint64_t count, std::size_t least) {
  const std::size_t digits = std::max(std::to_string(count - 1).size(), least);
  const std::string text = std::to_string(number);
  return std::string(digits - std::min(text.size(), digits), '0') + text;
}

v1::DataSetPlan readPlan(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kPlanFile;
  if (!std::filesystem::exists(file))
    throw std::runtime_error("'" + folder.string() + "' is no data set; saccade-farm plan RECIPE -o '" +
                             folder.string() + "' makes one");
  const auto plan = readJson<v1::DataSetPlan>(file);
  if (plan.sequences() == 0 || plan.shards() == 0 || plan.shards() > plan.sequences())
    throw std::runtime_error(file.string() + " says neither sequences nor shards that can be");
  return plan;
}

}  // namespace

std::string shardNameOf(std::uint32_t shard, std::uint32_t shards) {
  return padded(shard, shards, kShardDigits);
}

std::filesystem::path planTable(const std::filesystem::path& folder, const std::string& shard_name) {
  return folder / "plan" / (shard_name + ".jsonl");
}

DataSet::DataSet(const std::string& folder)
    : folder_(std::filesystem::absolute(folder).lexically_normal()), plan_(readPlan(folder_)) {}

std::string DataSet::shardName(std::uint32_t shard) const {
  return shardNameOf(shard, plan_.shards());
}

std::string DataSet::sequenceName(std::uint64_t number) const {
  return padded(number, plan_.sequences(), kSequenceDigits);
}

DataSet::Path DataSet::sequenceFolder(const v1::DataSetSequence& sequence) const {
  return shardFolder(sequence.shard()) / sequenceName(sequence.number());
}

DataSet::Path DataSet::failedFile(const v1::DataSetSequence& sequence) const {
  return failedFolder(sequence.shard()) / (sequenceName(sequence.number()) + ".json");
}

std::vector<v1::DataSetSequence> DataSet::planned(std::uint32_t shard) const {
  return readJsonLines<v1::DataSetSequence>(planTable(folder_, shardName(shard)));
}

std::uint32_t DataSet::shardOf(std::uint64_t number) const {
  return farm::shardOf(number, plan_.sequences(), plan_.shards());
}

std::uint64_t DataSet::first(std::uint32_t shard) const {
  return firstOf(shard, plan_.sequences(), plan_.shards());
}

}  // namespace saccade::farm
