#include "eval/bench/open_scene.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "render/renderer.h"
#include "scene/files/scene_error.h"
#include "scene/files/slow_load.h"
#include "scene/library/scene_format.h"
#include "scene/library/scene_library.h"

namespace saccade::eval {

std::string sceneFolder() {
  const char* folder = std::getenv("SACCADE_SCENES");
  return folder ? folder : SACCADE_SOURCE_SCENES;
}

std::string meshFolders() {
  const char* folders = std::getenv("SACCADE_MESHES");
  return folders ? folders : kDefaultMeshes;
}

std::vector<std::string> availableScenes() {
  std::vector<std::string> names;
  for (const SceneEntry& scene : SceneLibrary(sceneFolder(), meshFolders()).list()) {
    if (scene.unavailable.empty())
      names.push_back(scene.name);
    else
      std::fprintf(stderr, "left out: %s: %s\n", scene.name.c_str(), scene.unavailable.c_str());
  }
  return names;
}

std::shared_ptr<const RenderScene> openScene(const std::string& name_or_path) {
  const LoadProgress progress = tellSlowLoad(
      name_or_path, [](const std::string& text) { std::fprintf(stderr, "loading %s\n", text.c_str()); });
  const SceneLibrary library(sceneFolder(), meshFolders());
  if (library.find(name_or_path) || !looksLikeFile(name_or_path))
    return std::make_shared<RenderScene>(library.load(name_or_path, progress));
  return std::make_shared<RenderScene>(
      formatOf(name_or_path)
          .load(name_or_path, {.search_folders = splitFolders(meshFolders()), .progress = progress}));
}

Trajectory openTrajectory(const std::string& scene, const std::string& name_or_path,
                          const RenderScene& opened) {
  if (name_or_path.ends_with(".csv") || name_or_path.ends_with(".txt")) {
    std::ifstream file(name_or_path);
    if (!file) throw SceneError("cannot read the trajectory " + name_or_path);
    std::stringstream text;
    text << file.rdbuf();
    return parseTrajectory(text.str(), name_or_path);
  }
  const Scene& s = opened.description();
  const auto motion =
      isMotionName(name_or_path) ? namedMotion(name_or_path, s.fov_x_deg) : parseMotion(name_or_path);
  if (motion)
    return makeMotion(*motion, s.T_world_camera, probePoints(opened, s.T_world_camera, s.fov_x_deg));
  return SceneLibrary(sceneFolder(), meshFolders()).loadTrajectory(scene, name_or_path);
}

}  // namespace saccade::eval
