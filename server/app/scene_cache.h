// The scenes in memory: each is loaded once, and shared; and once more when its scene.xml has changed. Who
// has a scene keeps it as it was.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "app/limits.h"
#include "render/render_scene.h"
#include "render/simplify.h"
#include "scene/scene_library.h"

namespace saccade {

// Since the server started.
struct SceneLoads {
  std::atomic<std::uint64_t> done = 0, failed = 0;
  std::atomic<std::int64_t> ns = 0;  // time that took
};

class SceneCache {
 public:
  explicit SceneCache(const std::string& folder, const Limits& limits = {})
      : library_(folder), most_reduced_(static_cast<std::size_t>(limits[Limit::kReducedScenes])) {}

  const SceneLibrary& library() const { return library_; }
  const SceneLoads& loads() const { return loads_; }
  // Loads the scene, or waits for another thread that does. Throws SceneError; a later call tries again.
  std::shared_ptr<const RenderScene> get(const std::string& name);
  // The same without parts of its model; shared while anyone has it. Throws SceneError, and LimitReached
  // where too many others are in use.
  std::shared_ptr<const RenderScene> get(const std::string& name, const Parts& without);

  // What a scene needs, for people; empty until it was loaded.
  std::string needs(const std::string& name) const;

 private:
  using Loaded = std::shared_ptr<const RenderScene>;
  struct Entry {
    std::filesystem::file_time_type changed;
    std::shared_future<Loaded> scene;
  };
  struct Simplified {
    std::weak_ptr<const RenderScene> whole, scene;
  };
  Loaded load(const std::string& name);

  SceneLibrary library_;
  const std::size_t most_reduced_;
  SceneLoads loads_;
  mutable std::mutex mutex_;
  std::map<std::string, Entry> scenes_;
  std::map<std::string, std::string> needs_;  // of those that are loaded
  std::mutex simplifying_;
  std::map<std::pair<std::string, Parts>, Simplified> simplified_;
};

}  // namespace saccade
