// The scenes in memory: each is loaded once, and shared; and once more when its scene.xml has changed. Who
// has a scene keeps it as it was. Scenes that nobody has make room for others, the least recently used first.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/admission/limits.h"
#include "render/render_scene.h"
#include "render/simplify.h"
#include "scene/library/scene_library.h"

namespace saccade {

// Since the server started.
struct SceneLoads {
  std::atomic<std::uint64_t> done = 0, failed = 0, evicted = 0;
  std::atomic<std::int64_t> ns = 0;  // time that took
};

class SceneCache {
 public:
  explicit SceneCache(const std::string& folder, const Limits& limits = {})
      : library_(folder),
        most_reduced_(static_cast<std::size_t>(limits[Limit::kReducedScenes])),
        most_bytes_(limits.bytes(Limit::kScenes)) {}

  const SceneLibrary& library() const { return library_; }
  const SceneLoads& loads() const { return loads_; }
  std::uint64_t bytes() const;  // of all scenes in memory
  // Loads the scene, or waits for another thread that does. Throws SceneError, and LimitReached where there
  // is no room; a later call tries again.
  std::shared_ptr<const RenderScene> get(const std::string& name);
  // The same without parts of its model; shared while anyone has it. Throws SceneError, and LimitReached
  // where too many others are in use, or there is no room.
  std::shared_ptr<const RenderScene> get(const std::string& name, const SceneFeatures& disabled);

  // What a scene stats, for people; empty until it was loaded.
  std::string stats(const std::string& name) const;

 private:
  using Loaded = std::shared_ptr<const RenderScene>;
  struct Entry {
    std::filesystem::file_time_type changed;
    std::shared_future<Loaded> scene;
    std::uint64_t used = 0;  // when last: counts up
  };
  struct Simplified {
    std::weak_ptr<const RenderScene> whole, scene;
  };
  struct Counted {
    std::weak_ptr<const RenderScene> scene;
    std::uint64_t bytes;
  };
  Loaded load(const std::string& name);
  Loaded add(const std::string& name, Scene scene);
  void makeRoom(const std::string& name, std::uint64_t bytes);
  std::uint64_t countBytes() const;
  bool evictOne();

  SceneLibrary library_;
  const std::size_t most_reduced_;
  const std::uint64_t most_bytes_;
  SceneLoads loads_;
  std::mutex loading_;  // one at a time: what a scene takes is known once it is there
  mutable std::mutex mutex_;
  std::map<std::string, Entry> scenes_;
  std::uint64_t uses_ = 0;
  std::vector<Counted> counted_;              // those in memory, and some that were
  std::map<std::string, std::string> stats_;  // of those that are loaded
  std::mutex simplifying_;
  std::map<std::pair<std::string, SceneFeatures>, Simplified> simplified_;
};

}  // namespace saccade
