#include "farm/worker/run.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include "base/one_heap.h"
#include "base/usable_cpus.h"
#include "farm/worker/crew.h"
#include "farm/worker/failures.h"
#include "farm/worker/sequence_folder.h"
#include "farm/worker/worker_file.h"

namespace saccade::farm {
namespace {

constexpr int kWaitMs = 200;  // for signals and for workers that die

// The sequences of the shard that was asked for last.
class PlanPages {
 public:
  explicit PlanPages(const DataSet& set) : set_(set) {}
  const v1::DataSetSequence& at(std::uint64_t number) {
    const std::uint32_t shard = set_.shardOf(number);
    if (shard_ != shard) page_ = set_.planned(shard), shard_ = shard;
    return page_.at(number - set_.first(shard));
  }

 private:
  const DataSet& set_;
  std::optional<std::uint32_t> shard_;
  std::vector<v1::DataSetSequence> page_;
};

// The work of each worker, in its own process.
Crew::Begin workOf(const DataSet& set, const RenderSettings& settings, const std::string& name, int threads) {
  return [=, &set](int index) {
    useOneHeap();
    std::filesystem::current_path(set.recipeFolder());
    const auto pages = std::make_shared<PlanPages>(set);
    const auto renderer = std::make_shared<SequenceRenderer>(settings, threads);
    const std::string worker = name + "." + std::to_string(index);
    return
        [=, &set](std::uint64_t number) { return makeSequence(set, pages->at(number), worker, *renderer); };
  };
}

// Sequences of one scene follow each other, so that a worker needs few scenes at a time.
std::vector<v1::DataSetSequence> byScene(std::vector<v1::DataSetSequence> sequences) {
  std::ranges::stable_sort(sequences, {},
                           [](const v1::DataSetSequence& sequence) { return sequence.options(0); });
  return sequences;
}

class Run {
 public:
  using Tell = std::function<void(const RunCounts&, const std::string&)>;

  Run(const DataSet& set, const RunOptions& options, int cpus, int workers, const std::function<bool()>& stop,
      const Tell& tell)
      : set_(set),
        stop_(stop),
        tell_(tell),
        file_(set),
        crew_(workers, workOf(set, options.render, file_.name(), std::max(1, cpus / workers))) {}

  RunCounts over(std::uint32_t first, std::uint32_t end) {
    for (std::uint32_t shard = first; shard < end; ++shard) counts_.all += set_.shardSize(shard);
    // Runs that share a data set begin at shards of their own, and so seldom make the same sequence twice.
    const std::uint32_t shards = end - first, ahead = std::hash<std::string>{}(file_.name()) % shards;
    for (std::uint32_t i = 0; i < shards && !stop_(); ++i) begin(first + (i + ahead) % shards);
    while (crew_.busy() > 0 && !stop_()) await();
    crew_.stop();
    return counts_;
  }

 private:
  struct Open {
    std::vector<v1::DataSetSequence> planned;
    std::uint64_t left;  // sequences that are not settled yet
  };

  void begin(std::uint32_t shard) {
    const std::vector<v1::DataSetSequence> planned = set_.planned(shard);
    if (planned.size() != set_.shardSize(shard))
      throw std::runtime_error(planTable(set_.folder(), set_.shardName(shard)).string() + " has " +
                               std::to_string(planned.size()) + " lines instead of " +
                               std::to_string(set_.shardSize(shard)));
    open_[shard] = {planned, planned.size()};
    for (const v1::DataSetSequence& sequence : byScene(planned)) {
      while (!crew_.isIdle() && !stop_()) await();
      if (stop_()) return;
      if (isPublished(set_, sequence)) {
        settle(sequence, counts_.found);
      } else if (failedForEver(set_, sequence)) {
        settle(sequence, counts_.never);
      } else {
        give(sequence);
      }
    }
  }

  void give(const v1::DataSetSequence& sequence) {
    crew_.give(sequence.number());
    doing_ = set_.sequenceName(sequence.number());
    tellAll("");
  }

  void await() {
    const auto outcome = crew_.next(kWaitMs);
    if (!outcome) return;
    counts_.cpu_s += outcome->cpu_s;
    const std::uint32_t shard = set_.shardOf(outcome->number);
    const v1::DataSetSequence sequence = open_.at(shard).planned.at(outcome->number - set_.first(shard));
    const Made made = outcome->death.empty() ? outcome->made : died(sequence, outcome->death);
    std::string failure;
    if (made != Made::kDone) {
      const auto record = failureOf(set_, sequence);
      failure =
          "sequence " + set_.sequenceName(sequence.number()) + ": " + (record ? record->message() : "failed");
    }
    settle(sequence, made == Made::kDone    ? counts_.done
                     : made == Made::kRetry ? counts_.retry
                                            : counts_.never);
    tellAll(failure);
  }

  Made died(const v1::DataSetSequence& sequence, const std::string& death) {
    try {
      return recordCrash(set_, sequence, death).retry() ? Made::kRetry : Made::kNever;
    } catch (const std::system_error&) {  // a disk that is full
      return Made::kRetry;
    }
  }

  void settle(const v1::DataSetSequence& sequence, std::uint64_t& count) {
    ++count;
    const auto open = open_.find(sequence.shard());
    if (--open->second.left > 0) return;
    settleShard(set_, sequence.shard(), open->second.planned);
    open_.erase(open);
  }

  void tellAll(const std::string& failure) {
    v1::FarmWorker state;
    state.set_done(counts_.done), state.set_failed(counts_.retry + counts_.never),
        state.set_cpu_s(counts_.cpu_s);
    state.set_doing(doing_);
    state.set_running(static_cast<std::uint32_t>(crew_.busy()));
    file_.tell(state);
    tell_(counts_, failure);
  }

  const DataSet& set_;
  const std::function<bool()>& stop_;
  const Tell& tell_;
  WorkerFile file_;
  Crew crew_;
  RunCounts counts_;
  std::map<std::uint32_t, Open> open_;
  std::string doing_;
};

}  // namespace

int cpusGiven() {
  int cpus = std::max(1, static_cast<int>(std::floor(usableCpus())));
  if (const char* slurm = std::getenv("SLURM_CPUS_PER_TASK"))
    if (const int given = std::atoi(slurm); given > 0) cpus = std::min(cpus, given);
  return cpus;
}

RunCounts run(const DataSet& set, const RunOptions& options, const std::function<bool()>& stop,
              const std::function<void(const RunCounts&, const std::string&)>& tell) {
  removeLeftovers(set);
  std::filesystem::create_directories(set.partialFolder());
  const std::uint32_t first = options.shard.value_or(0);
  const std::uint32_t end = options.shard ? first + 1 : set.plan().shards();
  const int cpus = options.cpus > 0 ? options.cpus : cpusGiven();
  const int workers = options.workers > 0 ? options.workers : cpus;
  const RunCounts counts = Run(set, options, cpus, workers, stop, tell).over(first, end);
  removeLeftovers(set);  // also of the workers that stop() has ended
  return counts;
}

}  // namespace saccade::farm
