// saccade-farm check and plan: from a recipe to the folder of a data set.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>

#include "base/instruction_set.h"
#include "client/terminal/progress.h"
#include "farm/commands/commands.h"
#include "farm/plan/estimate.h"
#include "farm/plan/make_plan.h"
#include "farm/plan/recipe_check.h"
#include "farm/recipe/recipe_reader.h"

namespace saccade::farm {
namespace {

namespace fs = std::filesystem;

struct PlanOptions {
  std::string recipe, output, instructions = "auto";
  bool estimate = true;
  RenderSettings render = defaultRender();
};

void addRecipeOptions(CLI::App& command, PlanOptions& options) {
  command.add_option("recipe", options.recipe, "file of the recipe, see server/farm/README.md")->required();
  addRenderOptions(command, options.render);
  addTableOptions(command, options.render);
}

// Reads the recipe in its own folder, where the names of its files are found.
Recipe enter(PlanOptions& options) {
  for (std::string* path : {&options.render.scenes, &options.render.bakes, &options.render.accuracy,
                            &options.render.simplification, &options.output})
    if (!path->empty()) *path = fs::absolute(*path);
  Recipe recipe = readRecipe(options.recipe);
  const fs::path file = fs::absolute(options.recipe);
  fs::current_path(file.parent_path());
  recipe.path = file;
  return recipe;
}

void printPlan(const DataSet& set, const std::string& folder) {
  const v1::DataSetPlan& plan = set.plan();
  std::printf("%s: %llu sequences in %u shards\n", plan.name().c_str(),
              static_cast<unsigned long long>(plan.sequences()), plan.shards());
  for (const v1::DataSetSplit& split : plan.splits())
    std::printf("  %s: %llu\n", split.name().c_str(), static_cast<unsigned long long>(split.sequences()));
  for (const v1::DataSetSequence& sequence : set.planned(0)) {
    std::string words;
    for (const std::string& word : sequence.options()) words += " " + word;
    std::printf("sequence 0 is: saccade record%s\n", words.c_str());
    break;
  }
  std::printf("`saccade-farm run %s` renders them\n", folder.c_str());
}

void printEstimate(const Estimate& found) {
  std::printf(
      "estimates, from the first frames of %zu sequences: %s of CPU, %s, %.2g events; %s of memory for each "
      "worker\n",
      found.rendered, hoursText(found.cpu_s).c_str(), bytesText(found.bytes).c_str(),
      static_cast<double>(found.events), bytesText(found.memory_bytes).c_str());
}

int reported(const std::function<void()>& work) {
  try {
    work();
    return 0;
  } catch (const std::runtime_error& fault) {
    std::fprintf(stderr, "saccade-farm: %s\n", fault.what());
    return kNever;
  }
}

void runCheck(PlanOptions& options) {
  const Recipe recipe = enter(options);
  SequenceRenderer renderer(options.render, 1);
  checkRecipe(recipe, renderer);
  std::printf("%s: the recipe is valid\n", recipe.file.c_str());
}

void runPlan(PlanOptions& options) {
  const std::string folder = options.output;
  if (options.instructions != "auto") useInstructionSet(options.instructions);
  const Recipe recipe = enter(options);
  client::Progress progress(0);
  SequenceRenderer renderer(options.render, 1);
  progress.note("checking the recipe");
  checkRecipe(recipe, renderer);
  const auto tell = [&](double share) {
    progress.note("writing the table: " + std::to_string(std::lround(100 * share)) + " %");
  };
  const DataSet set = makePlan(recipe, options.output, renderer, tell);
  progress.finish();
  printPlan(set, folder);
  if (options.estimate) printEstimate(estimate(recipe, options.render));
}

}  // namespace

void addCheckCommand(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("check", "find what could fail of a recipe, before anything is rendered");
  const auto options = std::make_shared<PlanOptions>();
  addRecipeOptions(*command, *options);
  command->callback([options, &status] { status = reported([&] { runCheck(*options); }); });
}

void addPlanCommand(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("plan", "check a recipe, and make the folder of its data set");
  const auto options = std::make_shared<PlanOptions>();
  addRecipeOptions(*command, *options);
  command->add_option("-o,--output", options->output, "folder of the data set, which must be new or empty")
      ->required();
  command->add_flag("!--no-estimate", options->estimate,
                    "do not render anything to tell time, bytes and memory");
  command
      ->add_option("--instructions", options->instructions,
                   "vector instructions that all workers render with; auto: the widest of this processor")
      ->check(CLI::IsMember({"auto", "avx2", "avx512"}))
      ->capture_default_str();
  command->callback([options, &status] { status = reported([&] { runPlan(*options); }); });
}

}  // namespace saccade::farm
