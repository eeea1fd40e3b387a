#include "app/streams/scene_cache.h"

#include <algorithm>
#include <cmath>

#include "scene/files/scene_error.h"
#include "scene/files/slow_load.h"
#include "scene/scene_stats.h"
#include "scene/scene_warnings.h"

namespace saccade {
namespace {

// Ready, and held by nothing but the future.
bool isIdle(const std::shared_future<SceneCache::ScenePtr>& scene) {
  if (scene.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
  try {
    return scene.get().use_count() == 1;
  } catch (...) {
    return false;  // it could not be loaded
  }
}

std::string mib(std::uint64_t bytes) {
  constexpr double kMiB = 1 << 20;
  return std::to_string(std::lround(static_cast<double>(bytes) / kMiB));
}

}  // namespace

bool SceneCache::Version::operator==(const Version& other) const {
  return changed == other.changed && !whole.owner_before(other.whole) && !other.whole.owner_before(whole);
}

SceneCache::ScenePtr SceneCache::get(const std::string& name) {
  const FileTime changed = library_.lastChange(name);
  return getOrBuild({name, {}}, {changed, {}}, [&] { return load(name, changed); });
}

SceneCache::ScenePtr SceneCache::simplify(const std::string& name, const ScenePtr& whole,
                                          const SceneFeatures& disabled) {
  if (disabled.empty()) return whole;
  return getOrBuild({name, disabled}, {{}, whole},
                    [&] { return prepare(name, simplified(whole->description(), disabled)); });
}

// The first caller builds, the others wait for it.
SceneCache::ScenePtr SceneCache::getOrBuild(const Key& key, const Version& version,
                                            const std::function<ScenePtr()>& build) {
  std::packaged_task<ScenePtr()> task(build);
  std::unique_lock lock(mutex_);
  Entry& entry = enter(key);
  const bool first = !entry.scene.valid() || !(entry.version == version);
  if (first) entry = {version, task.get_future().share()};
  entry.used = ++uses_;
  const std::shared_future<ScenePtr> scene = entry.scene;
  lock.unlock();
  if (first) task();
  try {
    return scene.get();
  } catch (...) {
    if (!first) throw;
    lock.lock();
    const auto failed = entries_.find(key);
    if (failed != entries_.end() && failed->second.version == version) entries_.erase(failed);
    throw;
  }
}

// The entry of the key, perhaps a new one.
SceneCache::Entry& SceneCache::enter(const Key& key) {
  const auto known = entries_.find(key);
  if (known != entries_.end() || key.second.empty()) return entries_[key];
  const auto count = [&] {
    return static_cast<std::size_t>(std::count_if(
        entries_.begin(), entries_.end(), [](const auto& entry) { return !entry.first.second.empty(); }));
  };
  while (count() >= most_simplified_ && evictOne(true)) {
  }
  if (count() < most_simplified_) return entries_[key];
  throw LimitReached(Limit::kReducedScenes, "quality.disabled_features",
                     std::to_string(most_simplified_) + " other simplified scenes are in use", kRetrySeconds);
}

SceneCache::ScenePtr SceneCache::load(const std::string& name, FileTime changed) {
  const auto log = [this](const std::string& text) { log_.write(spdlog::level::info, "loading " + text); };
  const auto began = std::chrono::steady_clock::now();
  try {
    std::unique_lock reading(reading_);
    Scene read = library_.load(name, tellSlowLoad(name, log));
    reading.unlock();
    const auto scene = prepare(name, std::move(read));
    loads_.ns += (std::chrono::steady_clock::now() - began) / std::chrono::nanoseconds(1);
    ++loads_.done;
    std::string stats = statsOf(scene->description()).text();
    log_.write(spdlog::level::info, "loaded " + name + ": " + stats);
    for (const std::string& warning : warningsOf(scene->description())) {
      log_.write(spdlog::level::warn, name + ": " + warning);
      stats += "; warning: " + warning;
    }
    remember(name, changed, {stats, {}});
    return scene;
  } catch (const SceneError& fault) {
    ++loads_.failed;
    remember(name, changed, {{}, fault.what()});
    throw;
  } catch (...) {
    ++loads_.failed;
    throw;
  }
}

// Makes the scene ready for tracing. It is counted with what is known of it before, and then with all of it.
SceneCache::ScenePtr SceneCache::prepare(const std::string& name, Scene scene) {
  const SceneStats stats = statsOf(scene);
  auto being_built = std::make_shared<const int>();
  count(name, being_built, stats.geometry_bytes + stats.texture_bytes);
  auto ready = std::make_shared<const RenderScene>(std::move(scene));
  being_built.reset();
  count(name, ready, ready->bytes());
  return ready;
}

void SceneCache::count(const std::string& name, std::weak_ptr<const void> scene, std::uint64_t bytes) {
  std::lock_guard lock(mutex_);
  makeRoom(name, bytes);
  std::erase_if(counted_, [](const Counted& one) { return one.scene.expired(); });
  counted_.push_back({std::move(scene), bytes});
}

void SceneCache::makeRoom(const std::string& name, std::uint64_t bytes) {
  while (bytes <= most_bytes_ && countBytes() + bytes > most_bytes_ && evictOne(false)) {
  }
  const std::uint64_t taken = countBytes();
  if (taken + bytes <= most_bytes_) return;
  throw LimitReached(Limit::kScenes, "scene",
                     "the scene " + name + " takes " + mib(bytes) + " MiB; those in use take " + mib(taken) +
                         " of " + mib(most_bytes_),
                     bytes <= most_bytes_ ? kRetrySeconds : 0);
}

// Forgets the least recently used of the scenes that nobody uses. False: there is none.
bool SceneCache::evictOne(bool simplified_only) {
  auto oldest = entries_.end();
  for (auto it = entries_.begin(); it != entries_.end(); ++it) {
    const bool whole = it->first.second.empty();
    if ((simplified_only && whole) || !isIdle(it->second.scene)) continue;
    if (oldest == entries_.end() || it->second.used < oldest->second.used) oldest = it;
  }
  if (oldest == entries_.end()) return false;
  log_.write(spdlog::level::info, oldest->first.first + " makes room for another scene");
  entries_.erase(oldest);
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

void SceneCache::remember(const std::string& name, FileTime changed, SceneNote note) {
  std::lock_guard lock(mutex_);
  notes_[name] = {changed, std::move(note)};
}

SceneNote SceneCache::note(const std::string& name) const {
  const FileTime changed = library_.lastChange(name);
  std::lock_guard lock(mutex_);
  const auto found = notes_.find(name);
  return found == notes_.end() || found->second.changed != changed ? SceneNote{} : found->second.note;
}

}  // namespace saccade
