// Opens the scenes and trajectories that commands name.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "eval/bench/moving_objects.h"
#include "feed/feed.h"
#include "render/world/render_scene.h"
#include "scene/camera/motion.h"

namespace saccade::eval {

// A scene is named by its name in the library or by a path: a scene's file, or its folder, where
// a path has a "/". The library is $SACCADE_SCENES, by default the scenes of the source tree. Meshes that a
// scene names and does not hold are looked up in $SACCADE_MESHES, by default kDefaultMeshes.

// The names of the scenes that can be opened on this machine. Reports the others on stderr, with the reason.
std::vector<std::string> availableScenes();

// The name for tables and titles, by which the server knows the scene: of "mine/room/scene.xml" it is "room".
// A file with another name than those of kSceneStems gives its own, without the extension.
std::string sceneName(const std::string& name_or_path);

// Throws std::runtime_error where two scenes have one name, or a name holds a comma: tables could not tell
// them.
void requireTableNames(const std::vector<std::string>& names_or_paths);

// As the scene's file has it: nothing moves. `animation`: see LoadOptions. Throws SceneError.
std::shared_ptr<const RenderScene> openScene(const std::string& name_or_path,
                                             const std::string& animation = {});
// Its bodies are `objects` and those that it moves by itself, see setBodies(). Throws SceneError.
std::shared_ptr<const RenderScene> openMovingScene(const std::string& name_or_path,
                                                   const std::vector<MovingObject>& objects,
                                                   const std::string& animation = {});

// The scene without the parts that have faults, which are told one by one. None if there is nothing left to
// tell of. Does not throw SceneError.
std::optional<Scene> inspectScene(const std::string& name_or_path, std::vector<std::string>& faults);

// Whether a text names a file of poses, and such a file. Throws SceneError.
bool isTrajectoryFile(const std::string& text);
Trajectory readTrajectoryFile(const std::string& path);

// The words for a trajectory. A motion is a name ("right"), KIND:SPEED ("dolly:0.2"), or KIND:SPEEDpx in
// pixels per frame. Else it is a .csv or .txt file by path, or a trajectory of the scene. The width and the
// frame rate of `feed` give pixels per frame. Throws SceneError, which lists all of these.
Trajectory openTrajectory(const std::string& scene, const std::string& text, const RenderScene& opened,
                          const FeedConfig& feed);

// For the flag that takes such a text; `saccade record` has both of its names.
// Throws std::exception for a KIND:SPEED that cannot be.
void checkMotion(std::string text);

inline constexpr const char* kTrajectoryFlag = "--trajectory,--motion";
std::string trajectoryHelp();

}  // namespace saccade::eval
