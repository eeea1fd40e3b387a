#include "scene/scene_library.h"

#include <algorithm>
#include <cstdlib>
#include <map>

#include "scene/confinement.h"
#include "scene/mitsuba_xml.h"
#include "scene/motion.h"
#include "scene/scene_error.h"
#include "scene/text.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;

// Meshes that scenes use by $name and that are not ours to give.
struct OutsideMesh {
  fs::path path;
  std::string origin;  // for people: where to get it
};

std::map<std::string, OutsideMesh> outsideMeshes(const fs::path& scenes) {
  const char* real = std::getenv("SACCADE_REAL_SCENES");
  const fs::path project = fs::weakly_canonical(scenes).parent_path();
  const fs::path real_scenes = real ? fs::path(real) : project.parent_path() / "shared" / "scenes";
  return {{"bunny", {"/usr/share/glmark2/models/bunny.obj", "install the Debian package glmark2-data"}},
          {"dragon",
           {real_scenes / "meshes" / "dragon.obj",
            "set SACCADE_REAL_SCENES to a folder with meshes/dragon.obj"}}};
}

const char* const kLeadsOut = " leads out of the folder of the scenes";

std::string whyUnavailable(const fs::path& scene_file, const fs::path& scenes) {
  if (!mayRead(scene_file, {scenes})) return scene_file.string() + kLeadsOut;
  const std::string text = readFile(scene_file.string());
  for (const auto& [name, mesh] : outsideMeshes(scenes))
    if (text.find("$" + name) != text.npos && !fs::exists(mesh.path))
      return "the mesh " + mesh.path.string() + " is absent: " + mesh.origin;
  return {};
}

// The first line that is neither blank nor a title.
std::string describe(const fs::path& readme, const fs::path& scenes) {
  if (!fs::exists(readme) || !mayRead(readme, {scenes})) return {};
  const std::string bytes = readFile(readme.string());
  for (std::string_view text = bytes; !text.empty();) {
    const auto line = takeLine(text);
    if (!line.empty() && line[0] != '#') return std::string(line);
  }
  return {};
}

std::vector<std::string> csvNames(const fs::path& folder) {
  std::vector<std::string> names;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".csv") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

// Throws unless `name` is one of `valid`: so no name can lead out of the folder.
void requireName(const std::string& what, const std::string& name, const std::vector<std::string>& valid) {
  if (std::find(valid.begin(), valid.end(), name) != valid.end()) return;
  throw SceneError("no " + what + " is named '" + name + "'; there are: " + joinNames(valid));
}

std::vector<std::string> sceneNames(const fs::path& folder) {
  std::vector<std::string> names;
  if (!fs::is_directory(folder)) throw SceneError(folder.string() + ": is not a folder of scenes");
  for (const auto& entry : fs::directory_iterator(folder))
    if (fs::exists(entry.path() / "scene.xml")) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

SceneLibrary::SceneLibrary(fs::path folder) : folder_(std::move(folder)) {}

std::vector<SceneEntry> SceneLibrary::list() const {
  std::vector<SceneEntry> entries;
  for (const std::string& name : sceneNames(folder_)) {
    const fs::path scene = folder_ / name;
    SceneEntry entry{name, describe(scene / "README.md", folder_), csvNames(scene / "trajectories"),
                     whyUnavailable(scene / "scene.xml", folder_)};
    entry.trajectories.insert(entry.trajectories.end(), motionNames().begin(), motionNames().end());
    entries.push_back(std::move(entry));
  }
  return entries;
}

Scene SceneLibrary::load(const std::string& name, const LoadProgress& progress) const {
  requireName("scene", name, sceneNames(folder_));
  const fs::path file = folder_ / name / "scene.xml";
  if (const std::string why = whyUnavailable(file, folder_); !why.empty())
    throw SceneError(name + ": " + why);
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
  if (!mayRead(file, {folder_})) throw SceneError(file + kLeadsOut);
  return parseTrajectory(readFile(file), file);
}

}  // namespace saccade
