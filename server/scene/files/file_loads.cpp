#include "scene/files/file_loads.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <map>
#include <mutex>
#include <thread>

#include "base/cancelled.h"
#include "scene/files/limits.h"

namespace saccade {
namespace {

int threadsFor(const LoadOptions& options, int loads) {
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  const int threads = options.threads > 0 ? options.threads : std::clamp(cores, 1, kMaxLoadThreads);
  return std::min(threads, loads);
}

}  // namespace

void FileLoads::takePixels(std::size_t count) {
  if ((pixels_ += count) > kMaxScenePixels)
    throw SceneError("the scene's pictures have more than " + std::to_string(kMaxScenePixels) +
                     " pixels together");
}

void FileLoads::run(const LoadOptions& options) const {
  const int total = static_cast<int>(loads_.size());
  std::atomic<int> next = 0;
  std::mutex mutex;
  std::map<int, std::exception_ptr> faults;  // by the index of the load
  int done = 0;
  const auto work = [&] {
    for (int i = next++; i < total && !options.stop.stop_requested(); i = next++) {
      std::exception_ptr fault;
      try {
        loads_[static_cast<std::size_t>(i)].run();
      } catch (...) {
        fault = std::current_exception();
      }
      const std::lock_guard lock(mutex);
      if (fault) faults[i] = fault;
      if (options.progress) options.progress(++done, total);
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (int i = 1; i < threadsFor(options, total); ++i) helpers.emplace_back(work);
    work();
  }
  throwIfStopped(options.stop);
  for (const auto& [index, fault] : faults) {
    try {
      std::rethrow_exception(fault);
    } catch (const SceneError& e) {
      const SceneError told = loads_[static_cast<std::size_t>(index)].located(e.what());
      if (!options.fault) throw told;
      options.fault(told.what());
    }
  }
}

}  // namespace saccade
