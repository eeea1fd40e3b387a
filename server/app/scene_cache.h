// The scenes in memory: each is loaded once, and shared.
#pragma once

#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "render/render_scene.h"
#include "scene/scene_library.h"

namespace saccade {

class SceneCache {
 public:
  explicit SceneCache(const std::string& folder) : library_(folder) {}

  const SceneLibrary& library() const { return library_; }
  // Loads the scene, or waits for another thread that does. Throws SceneError; a later call tries again.
  std::shared_ptr<const RenderScene> get(const std::string& name);

 private:
  using Loaded = std::shared_ptr<const RenderScene>;

  SceneLibrary library_;
  std::mutex mutex_;
  std::map<std::string, std::shared_future<Loaded>> scenes_;
};

}  // namespace saccade
