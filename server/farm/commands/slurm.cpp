// saccade-farm slurm
#include <memory>

#include "client/terminal/console.h"
#include "farm/commands/commands.h"
#include "farm/commands/engine_command.h"
#include "farm/engines/slurm.h"
#include "farm/recipe/recipe.h"

namespace saccade::farm {
namespace {

void writeSlurm(const EngineCommand& common, SlurmOptions& options) {
  const DataSet set(common.folder);
  options.engine = engineOf(common, true);
  writeEngine(common, slurmScript(set, options));
  if (const std::uint32_t tasks = slurmTasks(set, options); tasks > kUsualMaxArraySize)
    client::print(stderr,
                  "saccade-farm: an array of %u tasks needs a Slurm whose MaxArraySize is greater than its "
                  "usual %u: see "
                  "`scontrol show config`. With --tasks 1000, each task makes several shards\n",
                  tasks, kUsualMaxArraySize);
}

}  // namespace

void addSlurmCommand(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("slurm", "write a batch script for Slurm: sbatch FILE");
  const auto common = std::make_shared<EngineCommand>();
  const auto options = std::make_shared<SlurmOptions>();
  addCommonOptions(*command, *common);
  addParallelOption(*command, *common);
  addProgramOption(*command, *common);
  command->add_option("--time", options->time,
                      "of a task, as sbatch takes it; otherwise the partition's limit");
  command
      ->add_option("--warning", options->warning_s, "seconds before the time is up, when a worker is ended")
      ->check(CLI::Range(1, 65535))
      ->capture_default_str();
  command
      ->add_option("--tasks", options->tasks, "of the array, which share the shards; 0: one for each shard")
      ->check(CLI::Range(0, static_cast<int>(kMostShards)))
      ->capture_default_str();
  command->callback([=, &status] { writeSlurm(*common, *options), status = 0; });
}

}  // namespace saccade::farm
