#include "app/scene_cache.h"

#include <spdlog/spdlog.h>

#include "app/refusal.h"
#include "scene/scene_needs.h"
#include "scene/slow_load.h"

namespace saccade {

SceneCache::Loaded SceneCache::load(const std::string& name) {
  const auto log = [](const std::string& text) { spdlog::info("loading {}", text); };
  const auto began = std::chrono::steady_clock::now();
  try {
    const auto scene = std::make_shared<const RenderScene>(library_.load(name, tellSlowLoad(name, log)));
    loads_.ns += (std::chrono::steady_clock::now() - began) / std::chrono::nanoseconds(1);
    ++loads_.done;
    const std::string needs = needsOf(scene->description()).text();
    spdlog::info("loaded {}: {}", name, needs);
    std::lock_guard lock(mutex_);
    needs_[name] = needs;
    return scene;
  } catch (...) {
    ++loads_.failed;
    throw;
  }
}

std::shared_ptr<const RenderScene> SceneCache::get(const std::string& name) {
  std::packaged_task<Loaded()> task([&] { return load(name); });
  const auto changed = library_.lastChange(name);
  std::unique_lock lock(mutex_);
  Entry& entry = scenes_[name];
  const bool first = !entry.scene.valid() || entry.changed != changed;
  if (first) entry = {changed, task.get_future().share()};
  const std::shared_future<Loaded> scene = entry.scene;
  lock.unlock();
  if (first) task();
  try {
    return scene.get();
  } catch (...) {
    lock.lock();
    if (const auto failed = scenes_.find(name);
        failed != scenes_.end() && failed->second.changed == changed) {
      scenes_.erase(failed);
    }
    throw;
  }
}

std::shared_ptr<const RenderScene> SceneCache::get(const std::string& name, const Parts& without) {
  const auto whole = get(name);
  if (without.empty()) return whole;
  std::lock_guard lock(simplifying_);
  std::erase_if(simplified_, [](const auto& entry) { return entry.second.scene.expired(); });
  const auto found = simplified_.find({name, without});
  if (found != simplified_.end() && found->second.whole.lock() == whole)
    if (auto scene = found->second.scene.lock()) return scene;
  if (simplified_.size() >= most_reduced_) {
    throw LimitReached(Limit::kReducedScenes, "quality.without",
                       std::to_string(most_reduced_) + " other scenes without parts of theirs are in use",
                       kRetrySeconds);
  }
  auto scene = std::make_shared<const RenderScene>(simplified(whole->description(), without));
  simplified_[{name, without}] = {whole, scene};
  return scene;
}

std::string SceneCache::needs(const std::string& name) const {
  std::lock_guard lock(mutex_);
  const auto found = needs_.find(name);
  return found == needs_.end() ? "" : found->second;
}

}  // namespace saccade
