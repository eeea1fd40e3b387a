#include "scene/file_loads.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <thread>

#include "base/tile_pool.h"

namespace saccade {
namespace {

int threadsFor(const LoadOptions& options, int loads) {
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  const int threads = options.threads > 0 ? options.threads : std::clamp(cores, 1, kMaxLoadThreads);
  return std::min(threads, loads);
}

}  // namespace

void FileLoads::run(const XmlFile& file, const LoadOptions& options) const {
  const int total = static_cast<int>(loads_.size());
  if (total == 0) return;
  std::mutex mutex;
  std::map<int, std::string> faults;  // by place in the order
  int done = 0;
  const auto runOne = [&](int i) {
    std::string fault;
    try {
      loads_[static_cast<std::size_t>(i)].run();
    } catch (const SceneError& e) {
      fault = e.what();
    }
    const std::lock_guard lock(mutex);
    if (!fault.empty()) faults[i] = fault;
    if (options.progress) options.progress(++done, total);
  };
  TilePool(threadsFor(options, total)).run(total, runOne);
  if (faults.empty()) return;
  const auto& [first, what] = *faults.begin();
  throw file.error(loads_[static_cast<std::size_t>(first)].at, what);
}

}  // namespace saccade
