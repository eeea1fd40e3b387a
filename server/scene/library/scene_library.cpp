#include "scene/library/scene_library.h"

#include <algorithm>

#include "base/names.h"
#include "scene/files/limits.h"
#include "scene/files/plain_file.h"
#include "scene/files/scene_error.h"
#include "scene/mitsuba/mitsuba_xml.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;

// Throws unless `name` is one of `valid`: so no name can lead out of the folder.
void requireName(const std::string& what, const std::string& name, const std::vector<std::string>& valid) {
  if (std::find(valid.begin(), valid.end(), name) != valid.end()) return;
  throw SceneError("no " + what + " is named '" + name + "'; there are: " + joinNames(valid));
}

// Those that have a scene.xml, and those of which that cannot be said.
std::vector<fs::path> sceneFolders(const fs::path& folder) {
  std::vector<fs::path> scenes = entriesOf(folder);
  std::erase_if(scenes, [](const fs::path& entry) { return isAbsent(entry / "scene.xml"); });
  return scenes;
}

std::vector<std::string> sceneNames(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::path& scene : sceneFolders(folder)) names.push_back(scene.filename().string());
  return names;
}

}  // namespace

SceneLibrary::SceneLibrary(fs::path folder) : folder_(std::move(folder)) {}

std::vector<SceneEntry> SceneLibrary::list() const {
  std::vector<SceneEntry> entries;
  for (const fs::path& scene : sceneFolders(folder_)) entries.push_back(describeScene(scene, folder_));
  return entries;
}

Scene SceneLibrary::load(const std::string& name, const LoadProgress& progress) const {
  requireName("scene", name, sceneNames(folder_));
  const fs::path file = folder_ / name / "scene.xml";
  try {
    requireAvailable(folder_ / name, folder_);
  } catch (const SceneError& why) {
    throw SceneError(name + ": " + why.what());
  }
  LoadOptions options;
  options.progress = progress;
  options.confined_to = {folder_};
  for (const auto& [mesh_name, mesh] : outsideMeshes(folder_)) {
    options.definitions[mesh_name] = mesh.path.string();
    options.confined_to.push_back(mesh.path);
  }
  return loadMitsubaXml(file.string(), options);
}

fs::file_time_type SceneLibrary::lastChange(const std::string& name) const {
  std::error_code absent;
  const auto time = fs::last_write_time(folder_ / name / "scene.xml", absent);
  return absent ? fs::file_time_type::min() : time;
}

Trajectory SceneLibrary::loadTrajectory(const std::string& scene, const std::string& name) const {
  requireName("scene", scene, sceneNames(folder_));
  const fs::path folder = folder_ / scene / "trajectories";
  requireName("trajectory of the scene " + scene, name, csvNames(folder));
  const std::string file = (folder / (name + ".csv")).string();
  requireWithin(file, folder_);
  return parseTrajectory(readFile(file, kMaxTrajectoryBytes), file);
}

}  // namespace saccade
