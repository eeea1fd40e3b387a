// Motions that a scene gives its own objects: the file motion.toml beside the scene's file. It may choose an
// animation of the scene's file, and has a table for each object, by the name of its shapes:
//   animation = "Run"       # of glTF: no other one plays
//   [turntable]
//   motion = "spin:45"      # KIND:SPEED, see object_motion.h
//   [train]
//   poses = "train.csv"     # a file in the same folder or below, as readPoses() takes it; the first is at 0
//   period = 4              # seconds, later than its last pose: there it is at the first one again, for ever
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "scene/files/load_options.h"
#include "scene/files/scene_error.h"
#include "scene/scene.h"

namespace saccade {

inline constexpr const char* kMotionFile = "motion.toml";
inline constexpr std::size_t kMostOwnMotions = 64;

// Sorted by name; none where there is no such file beside `scene_file`. `shapes`: the names that the scene
// has. Throws SceneError with file and line, and what would be valid.
std::vector<OwnMotion> readOwnMotions(const std::filesystem::path& scene_file,
                                      const std::set<std::string>& shapes, const LoadOptions& options);

// The animation that LoadOptions or motion.toml chooses, and a fault of this choice with its place.
struct ChosenAnimation {
  std::string name, place;

  SceneError error(const std::string& what) const { return SceneError(place + ": " + what); }
};
// None where none of them chooses. Throws SceneError.
std::optional<ChosenAnimation> chosenAnimation(const std::filesystem::path& scene_file,
                                               const LoadOptions& options);

// That of an object; nullptr where the scene does not move it.
const OwnMotion* ownMotion(const Scene& scene, const std::string& name);

// T_world_body of a body of `scene`, which has its name.
Trajectory makeOwnMotion(const OwnMotion& motion, const Scene& scene, const Body& body);

}  // namespace saccade
