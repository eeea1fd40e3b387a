#include "app/scene_cache.h"

#include <spdlog/spdlog.h>

#include "scene/slow_load.h"

namespace saccade {

std::shared_ptr<const RenderScene> SceneCache::get(const std::string& name) {
  std::packaged_task<Loaded()> load([&] {
    const auto log = [](const std::string& text) { spdlog::info("loading {}", text); };
    return std::make_shared<const RenderScene>(library_.load(name, tellSlowLoad(name, log)));
  });
  std::unique_lock lock(mutex_);
  const auto [entry, first] = scenes_.try_emplace(name);
  if (first) entry->second = load.get_future().share();
  const std::shared_future<Loaded> scene = entry->second;
  lock.unlock();
  if (first) load();
  try {
    return scene.get();
  } catch (...) {
    lock.lock();
    if (first) scenes_.erase(name);
    throw;
  }
}

}  // namespace saccade
