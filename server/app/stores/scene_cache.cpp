#include "app/stores/scene_cache.h"

#include <algorithm>
#include <cmath>

#include "base/mebibyte.h"
#include "render/world/render_scene.h"
#include "scene/files/scene_error.h"
#include "scene/files/slow_load.h"
#include "scene/motion/bodies.h"
#include "scene/scene_stats.h"
#include "scene/scene_warnings.h"

namespace saccade {
namespace {

std::string mib(std::uint64_t bytes) {
  return std::to_string(std::lround(static_cast<double>(bytes) / kMiB));
}

}  // namespace

bool SceneCache::Version::operator<(const Version& other) const {
  return changed != other.changed ? changed < other.changed : whole.owner_before(other.whole);
}

SceneCache::ScenePtr SceneCache::get(const std::string& name, const std::stop_token& stop,
                                     const std::function<void(double)>& progress,
                                     const std::string& animation) {
  const FileTime changed = library_.lastChange(name);
  const auto make = [=, this](const BuildContext& context) {
    return load(name, animation, changed, context);
  };
  return getOrBuild({name, {.animation = animation}}, {changed, {}}, stop, make, progress);
}

SceneCache::ScenePtr SceneCache::vary(const std::string& name, const ScenePtr& whole,
                                      const SceneVariant& variant, const std::stop_token& stop) {
  if (variant.isWhole()) return whole;
  return getOrBuild({name, variant}, {{}, whole}, stop, [=, this](const BuildContext&) {
    Scene scene = whole->description();
    setBodies(scene, variant.bodies);
    keepForms(scene, variant.rigid);
    return prepare(name, simplified(std::move(scene), variant.disabled));
  });
}

SceneCache::ScenePtr SceneCache::getOrBuild(const Key& key, const Version& version,
                                            const std::stop_token& stop, const Builds::Build& make,
                                            const Builds::Progress& progress) {
  if (auto scene = find(key, version)) return scene;
  const auto buildIt = [=, this](const BuildContext& context) {
    return build(key, version, [&] { return make(context); });
  };
  return builds_.get({key, version}, stop, buildIt, progress);
}

// The scene that is kept; another thread may just have built it.
SceneCache::ScenePtr SceneCache::build(const Key& key, const Version& version,
                                       const std::function<ScenePtr()>& make) {
  if (auto scene = find(key, version)) return scene;
  enter(key, version);
  ScenePtr scene;
  try {
    scene = make();
  } catch (...) {
    keep(key, version, nullptr);
    throw;
  }
  keep(key, version, scene);
  return scene;
}

// Null: it is not there.
SceneCache::ScenePtr SceneCache::find(const Key& key, const Version& version) {
  std::lock_guard lock(mutex_);
  const auto found = entries_.find(key);
  if (found == entries_.end() || !(found->second.version == version)) return nullptr;
  found->second.used = ++uses_;
  return found->second.scene;
}

// Makes an entry for a scene that is about to be built. It replaces that of another version.
void SceneCache::enter(const Key& key, const Version& version) {
  std::lock_guard lock(mutex_);
  const auto count = [&] {
    return static_cast<std::size_t>(std::count_if(
        entries_.begin(), entries_.end(), [](const auto& entry) { return !entry.first.second.isWhole(); }));
  };
  const bool is_new = !entries_.contains(key);
  if (!key.second.isWhole() && is_new) {
    while (count() >= most_variants_ && evictOne(true)) {
    }
    if (count() >= most_variants_) {
      const bool moves = !key.second.bodies.empty();
      throw LimitReached(
          Limit::kReducedScenes, moves ? "objects" : "quality.disabled_features",
          std::to_string(most_variants_) + " other scenes, simplified or with objects that move, are in use",
          kRetrySeconds);
    }
  }
  entries_[key] = {version, nullptr, ++uses_};
}

// Ends what enter() began. Null: it could not be built.
void SceneCache::keep(const Key& key, const Version& version, const ScenePtr& scene) {
  std::lock_guard lock(mutex_);
  const auto found = entries_.find(key);
  if (found == entries_.end() || !(found->second.version == version)) return;  // there is a newer version
  found->second.scene = scene;
  if (!scene) entries_.erase(found);
}

SceneCache::ScenePtr SceneCache::load(const std::string& name, const std::string& animation, FileTime changed,
                                      const BuildContext& context) {
  const auto began = std::chrono::steady_clock::now();
  try {
    const ScenePtr scene = read(name, animation, context);
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
  } catch (const Cancelled&) {
    log_.write(spdlog::level::info, "stopped loading " + name + ", for which nobody waits any more");
    throw;
  } catch (const SceneError& fault) {
    ++loads_.failed;
    remember(name, changed, {{}, fault.what()});
    throw;
  } catch (...) {
    ++loads_.failed;
    throw;
  }
}

SceneCache::ScenePtr SceneCache::read(const std::string& name, const std::string& animation,
                                      const BuildContext& context) {
  auto tell = tellSlowLoad(
      name, [this](const std::string& text) { log_.write(spdlog::level::info, "loading " + text); });
  const auto tellBoth = [&](int done, int total) {
    tell(done, total);
    context.setProgress(static_cast<double>(done) / total);
  };
  std::unique_lock reading(reading_);
  throwIfStopped(context.stop);
  Scene scene = library_.load(name, tellBoth, context.stop, animation);
  reading.unlock();
  return prepare(name, std::move(scene));
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
bool SceneCache::evictOne(bool variants_only) {
  auto oldest = entries_.end();
  for (auto it = entries_.begin(); it != entries_.end(); ++it) {
    const bool whole = it->first.second.isWhole();
    if ((variants_only && whole) || it->second.scene.use_count() != 1) continue;
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

SceneUse SceneCache::inUse() const {
  std::lock_guard lock(mutex_);
  SceneUse use{.bytes = countBytes()};
  for (const auto& [key, entry] : entries_) {
    const bool unused = entry.scene.use_count() == 1;
    if (unused) use.bytes -= std::min(use.bytes, entry.scene->bytes());
    if (!unused && !key.second.isWhole()) ++use.variants;
  }
  return use;
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
