// The scenes a server offers: folders scenes/<name>/ with the scene's file, trajectories/*.csv and README.md.
// Nothing outside of scenes/ is read, wherever names and links lead, except in the folders of meshes.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "scene/camera/trajectory.h"
#include "scene/files/load_options.h"
#include "scene/files/search_folders.h"
#include "scene/library/scene_folder.h"
#include "scene/scene.h"

namespace saccade {

// All members may be called from any thread.
class SceneLibrary {
 public:
  // `folder` holds one folder per scene. `meshes` lists folders as splitFolders() reads them.
  explicit SceneLibrary(std::filesystem::path folder, const std::string& meshes = kDefaultMeshes);

  const std::filesystem::path& folder() const { return folder_; }

  // All scenes, sorted by name; one that cannot be read is listed with the reason. Answers from an index, and
  // reads only what has changed since the last call. Throws SceneError where the folder cannot be read.
  std::vector<SceneEntry> list() const;
  // Name and trajectories of one scene; reads no file. Empty: there is no such scene.
  std::optional<SceneEntry> find(const std::string& name) const;
  // `animation`: see LoadOptions. Throws SceneError: an unknown name, with the valid ones; a faulty file.
  // Throws Cancelled between files once `stop` is requested.
  Scene load(const std::string& name, const LoadProgress& progress = {}, const std::stop_token& stop = {},
             const std::string& animation = {}) const;
  // Those of a scene that there is, as list() has them. Answers from the index, too.
  std::vector<std::string> animations(const std::string& name) const;
  // Says that there is no such scene, and which there are. Throws SceneError where the folder cannot be read.
  std::string unknown(const std::string& name) const;
  // The latest time at which the scene's file, that of its motions or that of its values was written. Without
  // any it is the beginning of time.
  std::filesystem::file_time_type lastChange(const std::string& name) const;
  // A trajectory from the scene's CSV files, or one of Scene::paths, for which the whole scene is read.
  // Throws SceneError that names the valid ones.
  Trajectory loadTrajectory(const std::string& scene, const std::string& name) const;

 private:
  using Times = std::vector<std::filesystem::file_time_type>;
  struct Indexed {
    Times changed;  // of what the entry was read from
    SceneEntry entry;
  };
  bool contains(const std::string& name) const;
  Indexed refreshed(const std::filesystem::path& scene) const;

  const std::filesystem::path folder_;
  LoadOptions options_;
  mutable std::mutex mutex_;
  mutable std::map<std::filesystem::path, Indexed> index_;  // by folder
};

}  // namespace saccade
