// A room in which bodies move.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/test_scenes.h"
#include "render/world/posed_scene.h"
#include "scene/motion/bodies.h"

namespace saccade::test {

inline const Pose kMoved{{0.2, 0.1, -0.15}, axisAngle({0.3, -0.5, 0.2})};

// A room with a lamp, a card and a ball.
inline Scene movingRoom() {
  Scene s = furnace(0.6f, 0);
  s.meshes.push_back(quad({-0.3f, -0.95f, -0.3f}, {0, 0, 0.6f}, {0.6f, 0, 0}, 0, {9, 9, 9}));
  s.meshes.back().name = "lamp";
  s.meshes.push_back(quad({-0.5f, 0.1f, 0.3f}, {0.5f, 0, 0.1f}, {0, 0.5f, 0}, 0));
  s.meshes.back().name = "card";
  s.meshes.back().normals.assign(4, normalize(Vec3{0.1f, 0.2f, -1}));
  s.spheres = {{"ball", {0.4f, 0.5f, 0.5f}, 0.3f, 0, {}}};
  return s;
}

inline std::shared_ptr<const RenderScene> withBodies(const std::vector<std::string>& names) {
  Scene s = movingRoom();
  setBodies(s, names);
  return std::make_shared<RenderScene>(std::move(s));
}

inline Trajectory standing(const Body& body, const Pose& step = {}) {
  return Trajectory({{TimeNs(0), Pose{toDouble(body.centre()), {}} * step}});
}

// The pose of a body that kMoved moves from the file's place.
inline RigidMotion motionBy(const Body& body, const Pose& step) {
  return motionOf(body, Pose{toDouble(body.centre()), {}} * step);
}

}  // namespace saccade::test
