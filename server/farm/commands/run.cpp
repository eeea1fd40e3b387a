// saccade-farm run: renders what is missing of a data set.
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "base/instruction_set.h"
#include "client/terminal/console.h"
#include "client/terminal/interrupt.h"
#include "client/terminal/progress.h"
#include "farm/commands/commands.h"
#include "farm/worker/run.h"

namespace saccade::farm {
namespace {

struct Options {
  std::string folder, shard;
  RunOptions run;
};

// Reads "3/100", which must be of as many shards as the plan has.
std::optional<std::uint32_t> shardOfText(const std::string& text, const v1::DataSetPlan& plan) {
  if (text.empty()) return std::nullopt;
  unsigned shard = 0, shards = 0;
  int length = 0;
  if (std::sscanf(text.c_str(), "%9u/%9u%n", &shard, &shards, &length) != 2 ||
      text[static_cast<std::size_t>(length)])
    throw std::invalid_argument("--shard: '" + text + "' is not K/N, such as 3/100");
  if (shards != plan.shards() || shard >= shards)
    throw std::invalid_argument("--shard: the plan has the shards 0/" + std::to_string(plan.shards()) +
                                " to " + std::to_string(plan.shards() - 1) + "/" +
                                std::to_string(plan.shards()));
  return shard;
}

// Empty, or why this build cannot run the plan.
std::string buildFault(const v1::DataSetPlan& plan) {
  if (plan.software_version() == SACCADE_VERSION) return "";
  return "the data set was planned by version " + plan.software_version() + ", and this is " +
         SACCADE_VERSION + ": files of both would differ";
}

std::string countsText(const RunCounts& counts, double elapsed_s) {
  const std::uint64_t failed = counts.retry + counts.never, settled = counts.found + counts.done + failed;
  std::string text =
      std::to_string(counts.found + counts.done) + " of " + std::to_string(counts.all) + " sequences";
  if (failed > 0) text += ", " + std::to_string(failed) + " failed";
  if (counts.done == 0 || elapsed_s <= 0) return text;
  const double rate = static_cast<double>(counts.done) / elapsed_s;
  char number[32];
  std::snprintf(number, sizeof number, "%.2g", rate);
  return text + ", " + number + " a second, " +
         client::timeText(static_cast<double>(counts.all - settled) / rate) + " left";
}

int finish(const RunCounts& counts, bool interrupted, double elapsed_s, const std::string& folder) {
  client::print("%s; %s of CPU in %s\n", countsText(counts, 0).c_str(),
                client::timeText(counts.cpu_s).c_str(), client::timeText(elapsed_s).c_str());
  const bool more = counts.retry > 0 || interrupted;
  if (more)
    client::print(stderr, "saccade-farm: `saccade-farm run %s` makes what is missing\n", folder.c_str());
  if (more) return kTryAgain;
  return counts.never > 0 ? kNever : 0;
}

int runRun(Options& options) {
  const DataSet set(options.folder);
  options.run.shard = shardOfText(options.shard, set.plan());
  if (const std::string fault = buildFault(set.plan()); !fault.empty()) {
    client::print(stderr, "saccade-farm: %s\n", fault.c_str());
    return kNever;
  }
  useInstructionSet(set.plan().instruction_set());  // another machine may have it
  client::watchInterrupt();
  client::Progress progress(0);
  const RunCounts counts =
      run(set, options.run, client::interrupted, [&](const RunCounts& now, const std::string& failure) {
        if (!failure.empty()) progress.tell("saccade-farm: " + failure);
        progress.note(countsText(now, progress.elapsed_s()));
      });
  progress.finish();
  return finish(counts, client::interrupted(), progress.elapsed_s(), options.folder);
}

}  // namespace

void addRunCommand(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("run", "render what is missing of a data set");
  const auto options = std::make_shared<Options>();
  options->run.render = defaultRender();
  addFolderOption(*command, options->folder);
  command->add_option("--shard", options->shard, "K/N: only shard K, from 0 on, of the N of the plan");
  command
      ->add_option("--workers", options->run.workers,
                   "processes that render; 0: one for each CPU. Fewer workers have more threads each")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command
      ->add_option("--cpus", options->run.cpus,
                   "CPUs to use; 0: those that this program may use, and at most SLURM_CPUS_PER_TASK")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  addRenderOptions(*command, options->run.render);
  command->footer(
      "Several runs may share a data set, on several machines. What is there already is not made again.\n"
      "Exit codes: 0 all is there, 2 wrong usage, 75 another run may make what is missing, 78 something can "
      "never be made.");
  command->callback([options, &status] { status = runRun(*options); });
}

}  // namespace saccade::farm
