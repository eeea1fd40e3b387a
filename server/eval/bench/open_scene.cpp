#include "eval/bench/open_scene.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "base/names.h"
#include "render/camera/scene_motion.h"
#include "scene/files/scene_error.h"
#include "scene/files/slow_load.h"
#include "scene/library/scene_format.h"
#include "scene/library/scene_library.h"
#include "scene/scene_warnings.h"

namespace saccade::eval {
namespace {

namespace fs = std::filesystem;

std::string meshFolders() {
  const char* folders = std::getenv("SACCADE_MESHES");
  return folders ? folders : kDefaultMeshes;
}

SceneLibrary ownLibrary() {
  const char* folder = std::getenv("SACCADE_SCENES");
  return SceneLibrary(folder ? folder : SACCADE_SOURCE_SCENES, meshFolders());
}

// The scene's file where it is named by path, else an empty path.
fs::path fileOf(const std::string& name_or_path) {
  if (!looksLikeFile(name_or_path) || ownLibrary().find(name_or_path)) return {};
  const fs::path path = fs::absolute(name_or_path).lexically_normal();
  return path.has_extension() && !fs::is_directory(path) ? path : sceneFileIn(path);
}

// KIND:SPEED or KIND:SPEEDpx; none where there is no colon.
std::optional<Motion> readMotion(std::string text, const FeedConfig& feed) {
  const bool in_pixels = text.ends_with("px");
  if (in_pixels) text.resize(text.size() - 2);
  std::optional<Motion> motion = parseMotion(text);
  if (!motion || !in_pixels) return motion;
  motion->speed *= feed.frame_rate_hz / feed.camera.focal();
  motion->image_speed = true;
  return motion;
}

// A trajectory from the CSV files of a scene.
Trajectory ofTheScene(const std::string& scene, const std::string& name) {
  const fs::path file = fileOf(scene);
  const fs::path folder = file.parent_path();
  const SceneLibrary library =
      file.empty() ? ownLibrary() : SceneLibrary(folder.parent_path(), meshFolders());
  const std::string entry = file.empty() ? scene : folder.filename().string();
  const std::vector<SceneEntry> all = library.list();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& e) { return e.name == entry; });
  const std::vector<std::string> names = found == all.end() ? motionNames() : found->trajectories;
  if (std::find(names.begin(), names.end(), name) != names.end()) return library.loadTrajectory(entry, name);
  throw SceneError("no trajectory is named '" + name + "'; there are: " + joinNames(names) +
                   ", a .csv or .txt file, and KIND:SPEED or KIND:SPEEDpx of " + joinNames(motionKinds()));
}

}  // namespace

bool isTrajectoryFile(const std::string& text) {
  return text.ends_with(".csv") || text.ends_with(".txt");
}

Trajectory readTrajectoryFile(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw SceneError("cannot read the trajectory " + path);
  std::stringstream text;
  text << file.rdbuf();
  return parseTrajectory(text.str(), path);
}

std::vector<std::string> availableScenes() {
  std::vector<std::string> names;
  for (const SceneEntry& scene : ownLibrary().list()) {
    if (scene.unavailable.empty())
      names.push_back(scene.name);
    else
      std::fprintf(stderr, "left out: %s: %s\n", scene.name.c_str(), scene.unavailable.c_str());
  }
  return names;
}

std::string sceneName(const std::string& name_or_path) {
  const fs::path file = fileOf(name_or_path);
  if (file.empty()) return name_or_path;
  return isSceneFile(file) ? file.parent_path().filename().string() : file.stem().string();
}

void requireTableNames(const std::vector<std::string>& names_or_paths) {
  std::map<std::string, std::string> seen;  // by name
  for (const std::string& scene : names_or_paths) {
    const std::string name = sceneName(scene);
    if (name.find(',') != name.npos)
      throw std::runtime_error("the scene's name '" + name + "' holds a comma, which separates columns");
    const auto [first, is_new] = seen.emplace(name, scene);
    if (!is_new)
      throw std::runtime_error("two scenes are named '" + name + "': " + first->second + " and " + scene +
                               "; the rows of a table hold the name alone");
  }
}

namespace {

Scene readScene(const std::string& name_or_path, const std::string& animation) {
  const LoadProgress progress = tellSlowLoad(
      name_or_path, [](const std::string& text) { std::fprintf(stderr, "loading %s\n", text.c_str()); });
  const fs::path file = fileOf(name_or_path);
  if (!file.empty())
    return loadSceneFile(
        file, {.search_folders = splitFolders(meshFolders()), .animation = animation, .progress = progress});
  if (!ownLibrary().find(name_or_path) && fs::is_directory(name_or_path))
    throw SceneError(ownLibrary().unknown(name_or_path) + "; the folder here is ./" + name_or_path);
  return ownLibrary().load(name_or_path, progress, {}, animation);
}

std::shared_ptr<const RenderScene> warnedOf(Scene scene, const std::string& name_or_path) {
  for (const std::string& warning : warningsOf(scene))
    std::fprintf(stderr, "warning: %s: %s\n", name_or_path.c_str(), warning.c_str());
  return std::make_shared<RenderScene>(std::move(scene));
}

}  // namespace

std::shared_ptr<const RenderScene> openScene(const std::string& name_or_path, const std::string& animation) {
  return warnedOf(readScene(name_or_path, animation), name_or_path);
}

std::shared_ptr<const RenderScene> openMovingScene(const std::string& name_or_path,
                                                   const std::vector<MovingObject>& objects,
                                                   const std::string& animation) {
  Scene scene = readScene(name_or_path, animation);
  setBodies(scene, objects);
  return warnedOf(std::move(scene), name_or_path);
}

Trajectory openTrajectory(const std::string& scene, const std::string& text, const RenderScene& opened,
                          const FeedConfig& feed) {
  if (isTrajectoryFile(text)) return readTrajectoryFile(text);
  const Scene& s = opened.description();
  const auto motion = isMotionName(text) ? namedMotion(text, s.fov_x_deg) : readMotion(text, feed);
  if (const ScenePath* path = findRow(s.paths, text); path && !motion) return path->path;
  if (!motion) return ofTheScene(scene, text);
  return motionIn(opened, *motion, s.T_world_camera, Lens(pinhole(s.fov_x_deg, 64, 48)));
}

std::optional<Scene> inspectScene(const std::string& name_or_path, std::vector<std::string>& faults) {
  const auto keep = [&](const std::string& fault) {
    if (std::find(faults.begin(), faults.end(), fault) == faults.end()) faults.push_back(fault);
  };
  const fs::path file = fileOf(name_or_path);
  const SceneLibrary library = ownLibrary();
  try {
    if (file.empty() && !library.find(name_or_path)) throw SceneError(library.unknown(name_or_path));
    return loadSceneFile(file.empty() ? sceneFileIn(library.folder() / name_or_path) : file,
                         {.search_folders = splitFolders(meshFolders()), .fault = keep});
  } catch (const SceneError& fault) {
    keep(fault.what());
    return {};
  }
}

void checkMotion(std::string text) {
  if (text.ends_with("px")) text.resize(text.size() - 2);
  parseMotion(text);
}

std::string trajectoryHelp() {
  return "path of the camera: " + joinNames(motionNames()) +
         ", KIND:SPEED (dolly:0.2), KIND:SPEEDpx in pixels per frame, a trajectory of the scene, or a .csv "
         "or "
         ".txt file";
}

}  // namespace saccade::eval
