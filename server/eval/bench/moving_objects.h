// The flag that moves objects of a scene.
#pragma once

#include <string>
#include <vector>

#include "scene/camera/trajectory.h"
#include "scene/scene.h"

namespace CLI {
class App;
}

namespace saccade::eval {

// An object of a scene, and its path: KIND:SPEED, see object_motion.h, KIND:SPEED/frame, the name of a file
// of poses, or "still".
struct MovingObject {
  std::string name, path;
};

// Adds --object NAME=PATH, which may come again.
void addObjectOption(CLI::App& app, std::vector<std::string>& objects);

// Adds --animation NAME.
void addAnimationOption(CLI::App& app, std::string& animation);

// Reads the texts NAME=PATH, of which no two name one object. Throws SceneError.
std::vector<MovingObject> parseObjects(const std::vector<std::string>& objects);

// Makes them the bodies of the scene, and those that the scene moves by itself, see own_motions.h. Without
// those that stand still. They are sorted by name, as the server has them. Throws SceneError.
void setBodies(Scene& scene, const std::vector<MovingObject>& objects);

// Of the bodies of the scene, which setBodies() made of these objects. Throws SceneError.
std::vector<Trajectory> openPaths(const Scene& scene, const std::vector<MovingObject>& objects,
                                  double frame_rate_hz);

}  // namespace saccade::eval
