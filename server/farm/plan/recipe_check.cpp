#include "farm/plan/recipe_check.h"

#include <algorithm>
#include <map>

#include "app/request/refusal.h"
#include "client/options/field_options.h"
#include "farm/plan/temporary_folder.h"
#include "farm/recipe/expand.h"
#include "farm/recipe/recipe_fault.h"
#include "farm/worker/record_words.h"
#include "scene/files/scene_error.h"

namespace saccade::farm {
namespace {

constexpr std::size_t kMostEdges = 512, kMostFirst = 128;  // probes of a case, and of the recipe
constexpr std::size_t kMostLoaded = 32;                    // probes of a scene whose path is found

// Names each option once, and only those that a recipe may have.
void checkOptions(const Recipe& recipe, const std::vector<Entry>& entries) {
  std::map<std::string, std::string> given;  // names by the first name of the option
  for (const Entry& entry : entries) {
    const auto fail = [&](const std::string& message) {
      throw RecipeFault(recipe.file, entry.line, "record." + entry.name + ": " + message);
    };
    try {
      const auto [twin, is_new] = given.emplace(optionNamed(entry.name), entry.name);
      if (!is_new) fail("is the same option as " + twin->second);
    } catch (const OptionFault& fault) {
      fail(fault.what());
    }
  }
  if (!given.contains("scene")) throw RecipeFault(recipe.file, 1, "record: there is no scene");
}

class Checker {
 public:
  Checker(const Recipe& recipe, SequenceRenderer& renderer) : recipe_(recipe), renderer_(renderer) {}

  void check(const Probe& probe) {
    of_case_ = probe.of_case;
    try {
      const std::vector<client::RecordJob> jobs = jobsOf(probe.sequence, recipe_.outputs, folder_.path());
      StreamPlan plan = renderer_.plan(jobs.front().request);
      if (loaded_[probe.sequence.options(0)]++ < kMostLoaded) renderer_.load(plan);
    } catch (const OptionFault& fault) {
      fail(fault.option, fault.what());
    } catch (const Refusal& refusal) {
      const std::string option = client::optionOf(refusal.field);
      fail(option.starts_with("--") ? option.substr(2) : option, refusal.what());
    } catch (const SceneError& fault) {
      fail("scene", fault.what());
    }
  }

 private:
  // With the line of the option; that of the output where the recipe does not have it.
  [[noreturn]] void fail(const std::string& option, const std::string& message) const {
    if (option == "output" || option == "format")
      throw RecipeFault(recipe_.file, recipe_.output_line, "record.output: " + message);
    const std::vector<Entry>& entries = recipe_.cases[of_case_];
    for (const Entry& entry : entries)
      if (entry.name == option || (!option.empty() && optionNamed(entry.name) == option))
        throw RecipeFault(recipe_.file, entry.line, "record." + entry.name + ": " + message);
    throw RecipeFault(recipe_.file, entries.empty() ? 1 : entries.front().line, "record: " + message);
  }

  const Recipe& recipe_;
  SequenceRenderer& renderer_;
  const TemporaryFolder folder_;  // in place of that of a sequence
  std::size_t of_case_ = 0;
  std::map<std::string, std::size_t> loaded_;  // probes, by scene
};

}  // namespace

void checkRecipe(const Recipe& recipe, SequenceRenderer& renderer) {
  for (const std::vector<Entry>& entries : recipe.cases) checkOptions(recipe, entries);
  Checker checker(recipe, renderer);
  for (const Probe& probe : edgeProbes(recipe, kMostEdges)) checker.check(probe);
  for (std::uint64_t i = 0; i < std::min<std::uint64_t>(recipe.sequences, kMostFirst); ++i)
    checker.check({i % recipe.cases.size(), sequenceOf(recipe, i)});
}

}  // namespace saccade::farm
