// Scenes and trajectories as the commands name them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/render_scene.h"
#include "scene/camera/motion.h"

namespace saccade::eval {

// The folder of our scenes: $SACCADE_SCENES, else that of the source tree.
std::string sceneFolder();

// The folders of meshes that scenes name and do not hold: $SACCADE_MESHES, else kDefaultMeshes.
std::string meshFolders();

// The names of our scenes that can be opened on this machine; says on stderr which cannot, and why.
std::vector<std::string> availableScenes();

// A scene of the library by name, or the file of a scene by its path. Throws SceneError.
std::shared_ptr<const RenderScene> openScene(const std::string& name_or_path);

// A CSV file by path, a motion by name or as parseMotion() reads it, or one of the scene's own. Throws
// SceneError.
Trajectory openTrajectory(const std::string& scene, const std::string& name_or_path,
                          const RenderScene& description);

}  // namespace saccade::eval
