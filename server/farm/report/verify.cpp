#include "farm/report/verify.h"

#include <algorithm>
#include <exception>
#include <set>

#include "farm/dataset/file_digest.h"
#include "farm/report/verify_shard.h"

namespace saccade::farm {
namespace {

namespace fs = std::filesystem;

// Names at the top of a data set.
const std::set<std::string> kTop{"plan.json", "plan",      "recipe",         "shards", "failed",    "partial",
                                 "workers",   "README.md", "croissant.json", "card",   "webdataset"};

// Names the entries of a folder that are not one for each shard. A folder that is not there has none.
void checkNames(const DataSet& set, const std::string& folder, const std::string& ending,
                Findings& findings) {
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(set.folder() / folder, none)) {
    const std::string name = entry.path().filename();
    const auto shard = numberOf(name.substr(0, name.size() - std::min(name.size(), ending.size())));
    if (!shard || *shard >= set.plan().shards() ||
        set.shardName(static_cast<std::uint32_t>(*shard)) + ending != name)
      findings.foreign(entry.path());
  }
}

void checkRecipe(const DataSet& set, Findings& findings) {
  const fs::path folder = set.recipeFolder();
  try {
    if (!fs::exists(folder)) return findings.miss(folder);
    if (digestOfFolder(folder) != set.plan().recipe_digest())
      findings.damaged(folder, "differs from its digest");
  } catch (const std::exception& fault) {
    findings.damaged(folder, std::string("cannot be read: ") + fault.what());
  }
}

}  // namespace

Verified verify(const DataSet& set, const std::function<void(const std::string&)>& tell,
                const std::function<void(const Verified&)>& step) {
  Findings findings(set, tell);
  for (const auto& entry : fs::directory_iterator(set.folder()))
    if (!kTop.contains(entry.path().filename())) findings.foreign(entry.path());
  checkRecipe(set, findings);
  checkNames(set, "plan", ".jsonl", findings);
  checkNames(set, "shards", "", findings);
  checkNames(set, "failed", "", findings);
  for (std::uint32_t shard = 0; shard < set.plan().shards(); ++shard) verifyShard(set, shard, findings, step);
  return findings.found;
}

}  // namespace saccade::farm
