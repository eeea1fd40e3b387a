#include "scene/motion/bodies.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/names.h"
#include "scene/files/scene_error.h"
#include "scene/shape_box.h"

namespace saccade {

std::set<std::string> shapeNames(const Scene& scene) {
  std::set<std::string> names;
  for (const Mesh& mesh : scene.meshes) names.insert(mesh.name);
  for (const Sphere& sphere : scene.spheres) names.insert(sphere.name);
  return names;
}

void setBodies(Scene& scene, std::span<const std::string> names) {
  SACCADE_CHECK(scene.bodies.empty() && names.size() <= kMostBodies);
  for (const std::string& name : names) {
    const int body = static_cast<int>(scene.bodies.size());
    if (std::ranges::any_of(scene.bodies, [&](const Body& other) { return other.name == name; }))
      throw SceneError("the object '" + name + "' is given twice");
    ShapeBox box;
    bool found = false;
    const auto take = [&](auto& shapes) {
      for (auto& shape : shapes)
        if (shape.name == name) shape.body = body, box.add(shape), found = true;
    };
    take(scene.meshes), take(scene.spheres);
    if (!found)
      throw SceneError("the scene has no object '" + name + "'; it has: " + joinNames(shapeNames(scene)));
    scene.bodies.push_back({name, box.low, box.high});
  }
}

void keepForms(Scene& scene, std::span<const std::string> names) {
  for (Mesh& mesh : scene.meshes)
    if (std::ranges::find(names, mesh.name) != names.end()) mesh.deformation = kKeepsForm;
}

TimeNs lastFormKey(const Scene& scene) {
  if (std::ranges::none_of(scene.meshes, deforms)) return TimeNs{0};
  float last = 0;
  const auto take = [&](const KeyTrack& keys) {
    if (!keys.times.empty()) last = std::max(last, keys.times.back());
  };
  for (const MovingNode& node : scene.nodes)
    for (const NodeTrack& track : node.tracks) take(track.keys);
  for (const Deformation& deformation : scene.deformations) take(deformation.weight_keys);
  return TimeNs{std::llround(double{last} * 1e9)};
}

}  // namespace saccade
