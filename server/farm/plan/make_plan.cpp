#include "farm/plan/make_plan.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "base/instruction_set.h"
#include "client/formats/common/output_file.h"
#include "farm/dataset/durable.h"
#include "farm/dataset/file_digest.h"
#include "farm/dataset/json_file.h"
#include "farm/plan/pinned_options.h"
#include "farm/recipe/expand.h"
#include "farm/recipe/recipe_fault.h"
#include "farm/worker/record_words.h"

namespace saccade::farm {
namespace {

namespace fs = std::filesystem;

bool isLetter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

// Copies files into the data set, each once.
class RecipeFiles {
 public:
  RecipeFiles(const Recipe& recipe, fs::path to) : recipe_(recipe), to_(std::move(to)) {
    fs::create_directories(to_);
    copy(recipe.path, kRecipeFile);
  }

  // The files that the options of a sequence name.
  void addOf(const v1::DataSetSequence& sequence) {
    for (const std::string& word : sequence.options()) {
      const std::string value = valueOf(word);
      const bool is_name = value.find(':') == value.npos && std::ranges::any_of(value, isLetter);
      if (is_name && fs::is_regular_file(value) && seen_.insert(value).second) copy(value, value);
    }
  }

 private:
  void copy(const fs::path& from, const fs::path& name) {
    const fs::path within = fs::canonical(from).lexically_relative(fs::current_path());
    if (within.empty() || *within.begin() == "..")
      throw RecipeFault(recipe_.file, 1, "'" + from.string() + "' leads out of the folder of the recipe");
    fs::create_directories((to_ / name).parent_path());
    fs::copy_file(from, to_ / name, fs::copy_options::overwrite_existing);
  }

  const Recipe& recipe_;
  const fs::path to_;
  std::set<fs::path> seen_;
};

void checkFolder(const fs::path& folder) {
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw std::runtime_error("'" + folder.string() + "' is not a folder");
  if (!fs::exists(folder)) return;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (name != "plan" && name != "recipe")  // which an interrupted plan leaves
      throw std::runtime_error("'" + folder.string() + "' has other files, such as '" + name + "'");
  }
}

v1::DataSetPlan describe(const Recipe& recipe, const fs::path& recipe_folder) {
  v1::DataSetPlan plan;
  plan.set_name(recipe.name);
  plan.set_sequences(recipe.sequences);
  plan.set_shards(recipe.shards);
  plan.set_seed(recipe.seed);
  const std::vector<std::uint64_t> sizes = splitSizes(recipe);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    v1::DataSetSplit& split = *plan.add_splits();
    split.set_name(recipe.splits[i].first);
    split.set_sequences(sizes[i]);
  }
  plan.set_recipe_digest(digestOfFolder(recipe_folder));
  plan.set_software_version(SACCADE_VERSION);
  plan.set_instruction_set(instructionSetName());
  for (const std::string& output : recipe.outputs) plan.add_outputs(output);
  return plan;
}

void writeTable(const Recipe& recipe, std::uint32_t shard, const std::string& file,
                const SequenceRenderer& renderer, RecipeFiles& files) {
  client::OutputFile table(file);
  const std::uint64_t end = firstOf(shard + 1, recipe.sequences, recipe.shards);
  for (std::uint64_t i = firstOf(shard, recipe.sequences, recipe.shards); i < end; ++i) {
    v1::DataSetSequence sequence = sequenceOf(recipe, i);
    files.addOf(sequence);
    pinOptions(renderer, recipe.outputs, sequence);
    table.append(jsonLine(sequence));
  }
  table.close();
  flushFile(file);
}

// The plan of the folder, where it is that of this recipe.
bool isPlanned(const Recipe& recipe, const fs::path& folder) {
  if (!fs::exists(folder / kPlanFile)) return false;
  if (readText(folder / "recipe" / kRecipeFile) == readText(recipe.path)) return true;
  throw std::runtime_error("'" + folder.string() + "' has been planned by another recipe; take a new folder");
}

}  // namespace

DataSet makePlan(const Recipe& recipe, const std::string& name, const SequenceRenderer& renderer,
                 const std::function<void(double)>& tell) {
  const fs::path folder(name);
  if (isPlanned(recipe, folder)) return DataSet(folder);
  checkFolder(folder);
  fs::create_directories(folder / "plan");
  RecipeFiles files(recipe, folder / "recipe");
  for (std::uint32_t shard = 0; shard < recipe.shards; ++shard) {
    writeTable(recipe, shard, planTable(folder, shardNameOf(shard, recipe.shards)), renderer, files);
    tell((shard + 1.0) / recipe.shards);
  }
  writeJson(folder / kPlanFile, describe(recipe, folder / "recipe"));
  return DataSet(folder);
}

}  // namespace saccade::farm
