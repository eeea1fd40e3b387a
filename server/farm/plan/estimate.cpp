#include "farm/plan/estimate.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/one_heap.h"
#include "base/thread_time.h"
#include "base/units.h"
#include "farm/plan/temporary_folder.h"
#include "farm/recipe/expand.h"
#include "farm/worker/record_words.h"

namespace saccade::farm {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRendered = 8;
constexpr std::uint64_t kMostLooked = 1000;  // sequences, for the scenes that there are
constexpr FrameIndex kFew = 2, kMore = 10;   // frames
constexpr double kSpareMemory = 1.1;

double mostMemory() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_maxrss) * 1024;
}

// One of each scene, then others.
std::vector<std::uint64_t> chosen(const Recipe& recipe) {
  std::vector<std::uint64_t> numbers;
  std::set<std::string> scenes;
  const std::uint64_t looked = std::min(recipe.sequences, kMostLooked);
  for (std::uint64_t i = 0; i < looked && numbers.size() < kMostRendered; ++i)
    if (scenes.insert(sequenceOf(recipe, i).options(0)).second) numbers.push_back(i);
  for (std::uint64_t i = 0; i < looked && numbers.size() < kMostRendered; ++i)
    if (std::ranges::find(numbers, i) == numbers.end()) numbers.push_back(i);
  return numbers;
}

struct Cost {
  double cpu_s, bytes, events;
};

Cost costOf(const v1::DataSetSequence& sequence, const Recipe& recipe, FrameIndex frames,
            const fs::path& folder, SequenceRenderer& renderer) {
  fs::create_directories(folder);
  const std::vector<client::RecordJob> jobs = jobsOf(sequence, recipe.outputs, folder);
  const auto before = processCpuTime();
  Cost cost{};
  for (const auto& recording : renderer.render(jobs, frames))
    cost.events += static_cast<double>(recording.second.events()) / static_cast<double>(jobs.size());
  cost.cpu_s = seconds(processCpuTime() - before);
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) cost.bytes += static_cast<double>(entry.file_size());
  fs::remove_all(folder);
  return cost;
}

// The cost of all frames, from that of few and of more.
double extended(double few, double more, double frames) {
  if (frames <= kMore) return more;
  return more + std::max(0.0, more - few) / (kMore - kFew) * (frames - kMore);
}

Estimate measure(const Recipe& recipe, const RenderSettings& settings, const fs::path& folder) {
  useOneHeap();
  SequenceRenderer renderer(settings, 1);
  Estimate sum;
  for (const std::uint64_t number : chosen(recipe)) {
    const v1::DataSetSequence sequence = sequenceOf(recipe, number);
    const auto cost = [&](FrameIndex frames) { return costOf(sequence, recipe, frames, folder, renderer); };
    cost(1);  // loads the scene
    const Cost few = cost(kFew), more = cost(kMore);
    const auto frames = static_cast<double>(
        renderer.plan(jobsOf(sequence, recipe.outputs, folder.parent_path()).front().request)
            .resolved.frames);
    sum.cpu_s += extended(few.cpu_s, more.cpu_s, frames);
    sum.bytes += extended(few.bytes, more.bytes, frames);
    sum.events += static_cast<std::uint64_t>(extended(few.events, more.events, frames));
    ++sum.rendered;
  }
  const double each = static_cast<double>(recipe.sequences) / static_cast<double>(sum.rendered);
  return {.cpu_s = sum.cpu_s * each,
          .bytes = sum.bytes * each,
          .memory_bytes = kSpareMemory * mostMemory(),
          .events = static_cast<std::uint64_t>(static_cast<double>(sum.events) * each),
          .rendered = sum.rendered};
}

[[noreturn]] void measureInChild(const Recipe& recipe, const RenderSettings& settings, const fs::path& folder,
                                 int out) {
  try {
    const Estimate found = measure(recipe, settings, folder);
    if (write(out, &found, sizeof found) == sizeof found) _exit(0);
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "saccade-farm: no estimate: %s\n", fault.what());
  }
  _exit(1);
}

}  // namespace

Estimate estimate(const Recipe& recipe, const RenderSettings& settings) {
  const TemporaryFolder folder;
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no estimate: there is no pipe");
  std::fflush(nullptr);  // the child must not print what waits
  const pid_t child = fork();
  if (child == 0) measureInChild(recipe, settings, fs::path(folder.path()) / "sequence", ends[1]);
  close(ends[1]);
  Estimate found;
  const bool read_all = read(ends[0], &found, sizeof found) == sizeof found;
  close(ends[0]);
  if (child > 0) waitpid(child, nullptr, 0);
  if (!read_all) throw std::runtime_error("no estimate: the first frames could not be rendered");
  return found;
}

}  // namespace saccade::farm
