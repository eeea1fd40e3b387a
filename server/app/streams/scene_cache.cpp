#include "app/streams/scene_cache.h"

#include <spdlog/spdlog.h>

#include <cmath>

#include "app/admission/limits.h"
#include "scene/files/slow_load.h"
#include "scene/scene_stats.h"

namespace saccade {
namespace {

// Loaded, and held by nobody but the future.
bool isIdle(const std::shared_future<std::shared_ptr<const RenderScene>>& scene) {
  if (scene.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
  try {
    return scene.get().use_count() == 1;
  } catch (...) {
    return false;  // it could not be loaded
  }
}

}  // namespace

SceneCache::Loaded SceneCache::load(const std::string& name) {
  const auto log = [](const std::string& text) { spdlog::info("loading {}", text); };
  const auto began = std::chrono::steady_clock::now();
  std::lock_guard loading(loading_);
  try {
    const auto scene = add(name, library_.load(name, tellSlowLoad(name, log)));
    loads_.ns += (std::chrono::steady_clock::now() - began) / std::chrono::nanoseconds(1);
    ++loads_.done;
    const std::string stats = statsOf(scene->description()).text();
    spdlog::info("loaded {}: {}", name, stats);
    std::lock_guard lock(mutex_);
    stats_[name] = stats;
    return scene;
  } catch (...) {
    ++loads_.failed;
    throw;
  }
}

// Makes it ready, and counts it.
SceneCache::Loaded SceneCache::add(const std::string& name, Scene scene) {
  auto ready = std::make_shared<const RenderScene>(std::move(scene));
  std::lock_guard lock(mutex_);
  makeRoom(name, ready->bytes());
  std::erase_if(counted_, [](const Counted& one) { return one.scene.expired(); });
  counted_.push_back({ready, ready->bytes()});
  return ready;
}

void SceneCache::makeRoom(const std::string& name, std::uint64_t bytes) {
  while (bytes <= most_bytes_ && countBytes() + bytes > most_bytes_ && evictOne()) {
  }
  const std::uint64_t taken = countBytes();
  if (taken + bytes <= most_bytes_) return;
  constexpr double kMiB = 1 << 20;
  throw LimitReached(Limit::kScenes, "scene",
                     "the scene " + name + " takes " + std::to_string(std::lround(bytes / kMiB)) +
                         " MiB; those in use take " + std::to_string(std::lround(taken / kMiB)) + " of " +
                         std::to_string(std::lround(most_bytes_ / kMiB)),
                     bytes <= most_bytes_ ? kRetrySeconds : 0);
}

// Forgets the scene that was used least recently, of those that nobody has. False: there is none.
bool SceneCache::evictOne() {
  auto oldest = scenes_.end();
  for (auto it = scenes_.begin(); it != scenes_.end(); ++it) {
    if (!isIdle(it->second.scene)) continue;
    if (oldest == scenes_.end() || it->second.used < oldest->second.used) oldest = it;
  }
  if (oldest == scenes_.end()) return false;
  spdlog::info("{} makes room for another scene", oldest->first);
  scenes_.erase(oldest);
  ++loads_.evicted;
  return true;
}

std::uint64_t SceneCache::countBytes() const {
  std::uint64_t sum = 0;
  for (const Counted& one : counted_) sum += one.scene.expired() ? 0 : one.bytes;
  return sum;
}

std::uint64_t SceneCache::bytes() const {
  std::lock_guard lock(mutex_);
  return countBytes();
}

std::shared_ptr<const RenderScene> SceneCache::get(const std::string& name) {
  std::packaged_task<Loaded()> task([&] { return load(name); });
  const auto changed = library_.lastChange(name);
  std::unique_lock lock(mutex_);
  Entry& entry = scenes_[name];
  const bool first = !entry.scene.valid() || entry.changed != changed;
  if (first) entry = {changed, task.get_future().share()};
  entry.used = ++uses_;
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

std::shared_ptr<const RenderScene> SceneCache::get(const std::string& name, const SceneFeatures& disabled) {
  const auto whole = get(name);
  if (disabled.empty()) return whole;
  std::lock_guard lock(simplifying_);
  std::erase_if(simplified_, [](const auto& entry) { return entry.second.scene.expired(); });
  const auto found = simplified_.find({name, disabled});
  if (found != simplified_.end() && found->second.whole.lock() == whole)
    if (auto scene = found->second.scene.lock()) return scene;
  if (simplified_.size() >= most_reduced_) {
    throw LimitReached(Limit::kReducedScenes, "quality.disabled_features",
                       std::to_string(most_reduced_) + " other scenes without parts of theirs are in use",
                       kRetrySeconds);
  }
  auto scene = add(name, simplified(whole->description(), disabled));
  simplified_[{name, disabled}] = {whole, scene};
  return scene;
}

std::string SceneCache::stats(const std::string& name) const {
  std::lock_guard lock(mutex_);
  const auto found = stats_.find(name);
  return found == stats_.end() ? "" : found->second;
}

}  // namespace saccade
