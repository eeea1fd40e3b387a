#include "scene/library/scene_library.h"

#include <algorithm>

#include "base/names.h"
#include "base/text_cut.h"
#include "scene/files/limits.h"
#include "scene/files/plain_file.h"
#include "scene/files/scene_error.h"
#include "scene/library/scene_format.h"
#include "scene/mitsuba/scene_values.h"
#include "scene/motion/own_motions.h"
#include "scene/sky/sky_file.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> sceneFolders(const fs::path& folder) {
  std::vector<fs::path> scenes = entriesOf(folder);
  std::erase_if(scenes, [](const fs::path& entry) { return isAbsent(sceneFileIn(entry)); });
  return scenes;
}

fs::file_time_type changeOf(const fs::path& path) {
  std::error_code absent;
  const auto time = fs::last_write_time(path, absent);
  return absent ? fs::file_time_type::min() : time;
}

}  // namespace

SceneLibrary::SceneLibrary(fs::path folder, const std::string& meshes) : folder_(std::move(folder)) {
  options_.search_folders = splitFolders(meshes);
  options_.confined_to = options_.search_folders;
  options_.confined_to.push_back(folder_);
}

std::vector<SceneEntry> SceneLibrary::list() const {
  std::lock_guard lock(mutex_);
  std::map<fs::path, Indexed> index;
  std::vector<SceneEntry> entries;
  for (const fs::path& scene : sceneFolders(folder_))
    entries.push_back(index.emplace(scene, refreshed(scene)).first->second.entry);
  index_ = std::move(index);
  return entries;
}

std::vector<std::string> SceneLibrary::animations(const std::string& name) const {
  const fs::path scene = folder_ / name;
  std::lock_guard lock(mutex_);
  return (index_[scene] = refreshed(scene)).entry.animations;
}

// A scene that was unavailable is read again: a mesh may have come, which is no change of its folder.
SceneLibrary::Indexed SceneLibrary::refreshed(const fs::path& scene) const {
  Times changed{changeOf(sceneFileIn(scene)),  changeOf(scene / kMotionFile),
                changeOf(scene / kValuesFile), changeOf(scene / kSkyFile),
                changeOf(scene / "README.md"), changeOf(scene / "trajectories")};
  const auto known = index_.find(scene);
  if (known != index_.end() && known->second.changed == changed && known->second.entry.unavailable.empty())
    return known->second;
  return {std::move(changed), describeScene(scene, folder_, options_)};
}

// A name is a single part of a path, so that none can lead out of the folder.
bool SceneLibrary::contains(const std::string& name) const {
  const bool is_part = name.find('/') == name.npos && name.find('\0') == name.npos;
  return is_part && !name.empty() && name != "." && name != ".." && !isAbsent(sceneFileIn(folder_ / name));
}

std::optional<SceneEntry> SceneLibrary::find(const std::string& name) const {
  if (!contains(name)) return {};
  return outlineScene(folder_ / name, folder_);
}

std::string SceneLibrary::unknown(const std::string& name) const {
  std::vector<std::string> names;
  for (const fs::path& scene : sceneFolders(folder_)) names.push_back(outlineScene(scene, folder_).name);
  const std::string asked = cutText(name, kMaxEcho);
  std::string what = "no scene is named '" + asked + "'";
  if (looksLikeFile(name)) {
    const std::string fault = formatFault(asked);
    what = fault.empty() ? asked + " is a file; give the name of a scene" : fault;
  }
  return what + "; there are: " + joinNames(names);
}

Scene SceneLibrary::load(const std::string& name, const LoadProgress& progress, const std::stop_token& stop,
                         const std::string& animation) const {
  if (!contains(name)) throw SceneError(unknown(name));
  LoadOptions options = options_;
  options.progress = progress, options.stop = stop, options.animation = animation;
  return loadSceneFile(sceneFileIn(folder_ / name), options);
}

fs::file_time_type SceneLibrary::lastChange(const std::string& name) const {
  const fs::path scene = folder_ / name;
  return std::max({changeOf(sceneFileIn(scene)), changeOf(scene / kMotionFile), changeOf(scene / kValuesFile),
                   changeOf(scene / kSkyFile)});
}

Trajectory SceneLibrary::loadTrajectory(const std::string& scene, const std::string& name) const {
  if (!contains(scene)) throw SceneError(unknown(scene));
  const fs::path folder = folder_ / scene / "trajectories";
  const std::vector<std::string> names = csvNames(folder);
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    const fs::path file = sceneFileIn(folder_ / scene);
    if (formatOf(file).has_paths) {
      const Scene loaded = loadSceneFile(file, options_);
      if (const ScenePath* path = findRow(loaded.paths, name)) return path->path;
    }
    throw SceneError("no trajectory of the scene " + scene + " is named '" + name +
                     "'; there are: " + joinNames(names));
  }
  const std::string file = (folder / (name + ".csv")).string();
  requireWithin(file, folder_);
  return parseTrajectory(readFile(file, kMaxTrajectoryBytes), file);
}

}  // namespace saccade
