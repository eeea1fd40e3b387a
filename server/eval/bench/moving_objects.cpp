#include "eval/bench/moving_objects.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <set>

#include "base/names.h"
#include "eval/bench/open_scene.h"
#include "scene/files/scene_error.h"
#include "scene/motion/bodies.h"
#include "scene/motion/object_motion.h"
#include "scene/motion/own_motions.h"

namespace saccade::eval {
namespace {

const std::string kStill = "still";

Trajectory readPath(const Scene& scene, const Body& body, std::string text, double frame_rate_hz) {
  if (isTrajectoryFile(text)) return readTrajectoryFile(text);
  constexpr std::string_view kPerFrame = "/frame";
  const bool per_frame = text.ends_with(kPerFrame);
  if (per_frame) text.resize(text.size() - kPerFrame.size());
  auto motion = parseObjectMotion(text);
  if (!motion)
    throw SceneError("'" + text + "' is no path of an object; give KIND:SPEED, with KIND one of " +
                     joinNames(objectMotionKinds()) + ", a .csv or .txt file, or " + kStill);
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
                     joinNames(objectMotionKinds()) + "; " + kStill +
                     " stops what the scene moves; may be given again");
}

void addAnimationOption(CLI::App& app, std::string& animation) {
  app.add_option("--animation", animation,
                 "the animation of a glTF scene that plays alone, by name; by default that of motion.toml, "
                 "else all that do not move the same");
}

std::vector<MovingObject> parseObjects(const std::vector<std::string>& objects) {
  std::vector<MovingObject> parsed;
  for (const std::string& text : objects) {
    const std::size_t equals = text.find('=');
    if (equals == text.npos || equals == 0)
      throw SceneError("--object: '" + text + "' is not NAME=PATH, such as bunny=spin:90");
    const MovingObject object{text.substr(0, equals), text.substr(equals + 1)};
    if (std::ranges::any_of(parsed, [&](const MovingObject& other) { return other.name == object.name; }))
      throw SceneError("--object: '" + object.name + "' is given twice");
    parsed.push_back(object);
  }
  return parsed;
}

void setBodies(Scene& scene, const std::vector<MovingObject>& objects) {
  const std::set<std::string> known = objectNames(scene);
  std::set<std::string> moving;
  for (const OwnMotion& own : scene.motions) moving.insert(own.name);
  for (const MovingObject& object : objects) {
    if (object.path == kStill && known.contains(object.name))
      moving.erase(object.name);
    else
      moving.insert(object.name);  // one that the scene does not have is refused
  }
  saccade::setBodies(scene, std::vector(moving.begin(), moving.end()));
}

std::vector<Trajectory> openPaths(const Scene& scene, const std::vector<MovingObject>& objects,
                                  double frame_rate_hz) {
  std::vector<Trajectory> paths;
  for (const Body& body : scene.bodies) {
    const auto given =
        std::ranges::find_if(objects, [&](const MovingObject& object) { return object.name == body.name; });
    paths.push_back(given != objects.end() ? openPath(scene, body, given->path, frame_rate_hz)
                                           : makeOwnMotion(*ownMotion(scene, body.name), scene, body));
  }
  return paths;
}

}  // namespace saccade::eval
