#include "eval/bench/moving_objects.h"

#include <CLI/CLI.hpp>

#include "base/names.h"
#include "eval/bench/open_scene.h"
#include "scene/files/scene_error.h"
#include "scene/motion/bodies.h"
#include "scene/motion/object_motion.h"

namespace saccade::eval {
namespace {

Trajectory readPath(const Scene& scene, const Body& body, std::string text, double frame_rate_hz) {
  if (isTrajectoryFile(text)) return readTrajectoryFile(text);
  constexpr std::string_view kPerFrame = "/frame";
  const bool per_frame = text.ends_with(kPerFrame);
  if (per_frame) text.resize(text.size() - kPerFrame.size());
  auto motion = parseObjectMotion(text);
  if (!motion)
    throw SceneError("'" + text + "' is no path of an object; give KIND:SPEED, with KIND one of " +
                     joinNames(objectMotionKinds()) + ", or a .csv or .txt file");
  if (per_frame) motion->speed *= frame_rate_hz;
  return makeObjectMotion(*motion, scene, body);
}

// Faults name the option.
Trajectory openPath(const Scene& scene, const Body& body, const std::string& text, double frame_rate_hz) {
  try {
    return readPath(scene, body, text, frame_rate_hz);
  } catch (const SceneError& fault) {
    throw SceneError("--object " + body.name + ": " + fault.what());
  }
}

}  // namespace

void addObjectOption(CLI::App& app, std::vector<std::string>& objects) {
  app.add_option("--object", objects,
                 "NAME=PATH moves the shapes of this name: KIND:SPEED, such as spin:90, KIND:SPEED/frame, or "
                 "a .csv or .txt file of poses; KIND is one of " +
                     joinNames(objectMotionKinds()) + "; may be given again");
}

std::vector<MovingObject> parseObjects(const std::vector<std::string>& objects) {
  std::vector<MovingObject> parsed;
  for (const std::string& text : objects) {
    const std::size_t equals = text.find('=');
    if (equals == text.npos || equals == 0)
      throw SceneError("--object: '" + text + "' is not NAME=PATH, such as bunny=spin:90");
    parsed.push_back({text.substr(0, equals), text.substr(equals + 1)});
  }
  return parsed;
}

void setBodies(Scene& scene, const std::vector<MovingObject>& objects) {
  std::vector<std::string> names;
  for (const MovingObject& object : objects) names.push_back(object.name);
  saccade::setBodies(scene, names);
}

std::vector<Trajectory> openPaths(const Scene& scene, const std::vector<MovingObject>& objects,
                                  double frame_rate_hz) {
  std::vector<Trajectory> paths;
  for (std::size_t i = 0; i < objects.size(); ++i)
    paths.push_back(openPath(scene, scene.bodies[i], objects[i].path, frame_rate_hz));
  return paths;
}

}  // namespace saccade::eval
