#include "farm/report/verify.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <map>
#include <set>

#include "farm/dataset/file_digest.h"
#include "farm/dataset/json_file.h"
#include "farm/worker/failures.h"
#include "farm/worker/sequence_folder.h"

namespace saccade::farm {
namespace {

namespace fs = std::filesystem;

// Names at the top of a data set.
const std::set<std::string> kTop{"plan.json", "plan",      "recipe",         "shards", "failed",    "partial",
                                 "workers",   "README.md", "croissant.json", "card",   "webdataset"};

class Verifier {
 public:
  Verifier(const DataSet& set, const std::function<void(const std::string&)>& tell)
      : set_(set), tell_(tell) {}

  void top() {
    for (const auto& entry : fs::directory_iterator(set_.folder()))
      if (!kTop.contains(entry.path().filename())) foreign(entry.path());
    if (digestOfFolder(set_.recipeFolder()) != set_.plan().recipe_digest())
      damaged(set_.recipeFolder(), "differs from its digest");
    std::error_code none;
    std::set<std::string> names;
    for (std::uint32_t shard = 0; shard < set_.plan().shards(); ++shard) names.insert(set_.shardName(shard));
    for (const auto& entry : fs::directory_iterator(set_.folder() / "shards", none))
      if (!names.contains(entry.path().filename())) foreign(entry.path());
  }

  void shard(std::uint32_t shard) {
    std::set<std::string> names;
    std::string index;
    for (const v1::DataSetSequence& planned : set_.planned(shard)) {
      names.insert(set_.sequenceName(planned.number()));
      if (failedForEver(set_, planned)) continue;
      if (!isPublished(set_, planned)) {
        miss(set_.sequenceFolder(planned));
      } else {
        index += sequence(planned);
      }
    }
    if (fs::exists(set_.indexFile(shard)) && readText(set_.indexFile(shard)) != index)
      damaged(set_.indexFile(shard), "is not the list of the sequences");
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(set_.shardFolder(shard), none))
      if (!names.contains(entry.path().filename()) && entry.path() != set_.indexFile(shard))
        foreign(entry.path());
  }

  Verified found = {};

 private:
  // Returns its sequence.json.
  std::string sequence(const v1::DataSetSequence& planned) {
    const fs::path folder = set_.sequenceFolder(planned);
    const std::string text = readText(folder / kSequenceFile);
    v1::DataSetSequence sequence;
    try {
      parseJson(text, folder / kSequenceFile, sequence);
    } catch (const std::exception& fault) {
      damaged(folder / kSequenceFile, "cannot be read");
      return text;
    }
    if (!isOf(sequence, planned)) damaged(folder / kSequenceFile, "is not of this sequence of the plan");
    const std::uint64_t faults = found.damaged + found.missing + found.foreign;
    files(folder, sequence);
    if (found.damaged + found.missing + found.foreign == faults) ++found.sequences;
    return text;
  }

  void files(const fs::path& folder, const v1::DataSetSequence& sequence) {
    std::map<std::string, v1::DataSetFile> there;
    for (v1::DataSetFile& file : filesOf(folder)) there[file.name()] = std::move(file);
    there.erase(kSequenceFile);
    for (const v1::DataSetFile& file : sequence.files()) {
      const auto at = there.find(file.name());
      if (at == there.end()) {
        miss(folder / file.name());
      } else if (at->second.digest() != file.digest()) {
        damaged(folder / file.name(), "differs from its digest");
      } else {
        found.bytes += file.bytes();
      }
      there.erase(file.name());
    }
    for (const auto& [name, file] : there) foreign(folder / name);
  }

  static bool isOf(const v1::DataSetSequence& sequence, const v1::DataSetSequence& planned) {
    return sequence.number() == planned.number() && sequence.split() == planned.split() &&
           std::ranges::equal(sequence.options(), planned.options());
  }

  std::string shown(const fs::path& path) const { return path.lexically_relative(set_.folder()); }
  void damaged(const fs::path& path, const std::string& how) {
    ++found.damaged;
    tell_("damaged: " + shown(path) + " " + how);
  }
  void miss(const fs::path& path) {
    ++found.missing;
    tell_("missing: " + shown(path));
  }
  void foreign(const fs::path& path) {
    ++found.foreign;
    tell_("foreign: " + shown(path));
  }

  const DataSet& set_;
  const std::function<void(const std::string&)>& tell_;
};

}  // namespace

Verified verify(const DataSet& set, const std::function<void(const std::string&)>& tell,
                const std::function<void(std::uint32_t)>& step) {
  Verifier verifier(set, tell);
  verifier.top();
  for (std::uint32_t shard = 0; shard < set.plan().shards(); ++shard) {
    verifier.shard(shard);
    step(shard);
  }
  return verifier.found;
}

}  // namespace saccade::farm
