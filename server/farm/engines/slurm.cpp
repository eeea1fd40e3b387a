#include "farm/engines/slurm.h"

#include <algorithm>
#include <regex>
#include <stdexcept>

#include "farm/engines/text.h"

namespace saccade::farm {
namespace {

// Slurm itself runs a task again after the loss of a node, a preemption and `scontrol requeue`. The script
// does so after the rest: a worker that a signal has ended, one that says 75, and the time limit.
constexpr const char* kScript = R"sh(#!/bin/bash
#SBATCH --job-name=@NAME@
#SBATCH --array=0-@LAST@@LIMIT@
#SBATCH --cpus-per-task=@CPUS@
#SBATCH --mem=@MEMORY@M
@TIME@#SBATCH --signal=B:USR1@@WARNING@
#SBATCH --requeue
#SBATCH --open-mode=append
set -u
# Makes the data set @NAME@. Submit it again to make what is missing: what is there is not made again.
program=@PROGRAM@
dataset=@DATASET@
shards=@SHARDS@ tasks=@TASKS@ most_restarts=@RETRIES@
worker='' stopped=''

stop() {
  stopped=$1
  [ -z "$worker" ] || kill -TERM "$worker" 2>/dev/null
}
trap 'stop time' USR1   # the time limit is near
trap 'stop slurm' TERM  # Slurm ends the task, and knows whether it comes again

# make SHARD: sets `code`, the exit code of the worker, or 128 and the number of the signal that has ended it.
make() {
  "$program" run "$dataset" --shard "$1/$shards"@RENDER@ &
  worker=$!
  [ -z "$stopped" ] || kill -TERM "$worker" 2>/dev/null
  while wait "$worker"; kill -0 "$worker" 2>/dev/null; do :; done  # a trap ends `wait` early
  wait "$worker"
  code=$?
  worker=''
}

published() {
  find "$dataset/shards/$(printf '%0@DIGITS@d' "$1")" -mindepth 2 -maxdepth 2 -name sequence.json 2>/dev/null | wc -l
}

# A task runs again as long as it makes progress, and a few times without.
may_restart() { ((${SLURM_RESTART_COUNT:-0} < most_restarts || $(published "$1") > $2)); }

result=0
for ((shard = SLURM_ARRAY_TASK_ID; shard < shards; shard += tasks)); do
  before=$(published "$shard")
  make "$shard"
  case $code in
    0) continue ;;
    2 | 78) result=$code; continue ;;  # no other run can mend it
  esac
  if [ "$stopped" != slurm ] && may_restart "$shard" "$before"; then
    echo "shard $shard ended with $code, and its task runs again" >&2
    scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"
  fi
  exit "$code"
done
exit "$result"
)sh";

std::string timeLine(const std::string& time) {
  static const std::regex kTime("[0-9]+(-[0-9]+)?(:[0-9]+){0,2}");
  if (time.empty()) return "";
  if (!std::regex_match(time, kTime))
    throw std::invalid_argument("--time: '" + time +
                                "' is not a time of Slurm: minutes, hours:minutes:seconds, days-hours");
  return "#SBATCH --time=" + time + "\n";
}

}  // namespace

std::uint32_t slurmTasks(const DataSet& set, const SlurmOptions& options) {
  const std::uint32_t shards = set.plan().shards();
  return options.tasks > 0 ? std::min(shards, static_cast<std::uint32_t>(options.tasks)) : shards;
}

std::string slurmScript(const DataSet& set, const SlurmOptions& options) {
  const EngineOptions& engine = options.engine;
  const std::uint32_t tasks = slurmTasks(set, options);
  return filled(kScript, {{"NAME", plainName(set)},
                          {"LAST", std::to_string(tasks - 1)},
                          {"LIMIT", engine.parallel > 0 ? "%" + std::to_string(engine.parallel) : ""},
                          {"CPUS", std::to_string(engine.cpus)},
                          {"MEMORY", std::to_string(engine.memory_mib)},
                          {"TIME", timeLine(options.time)},
                          {"WARNING", std::to_string(options.warning_s)},
                          {"PROGRAM", shellWord(engine.program)},
                          {"DATASET", shellWord(folderOf(set))},
                          {"SHARDS", std::to_string(set.plan().shards())},
                          {"TASKS", std::to_string(tasks)},
                          {"RETRIES", std::to_string(engine.retries)},
                          {"RENDER", shellWords(engine.render)},
                          {"DIGITS", std::to_string(shardDigits(set))}});
}

}  // namespace saccade::farm
